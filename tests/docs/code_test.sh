#!/usr/bin/env bash
# code_test.sh FOLDER: every line of C++ in the README stands in the example that it is taken from, which is compiled.
set -euo pipefail
readme=$1/README.md example=$1/examples/library_use/draw_mesh.cpp

lines=0
while read -r line; do
  lines=$((lines + 1))
  if ! sed 's/^ *//; s/ *$//' "$example" | grep -qxF -- "$line"; then
    echo "$readme: not in draw_mesh.cpp: $line" >&2
    exit 1
  fi
done < <(awk '/^```/ { cpp = $0 == "```cpp"; next } cpp && NF' "$readme")
((lines > 0))
