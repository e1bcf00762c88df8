#!/usr/bin/env bash
# code_test.sh FOLDER: every line of C++ in the README, and of CMake in docs/library.md, stands in a file that the tests build.
set -euo pipefail
cd "$1"

# check PAGE LANGUAGE FILE...: the lines of the page's blocks in that language stand in the files.
check() {
  local page=$1 language=$2 lines=0
  shift 2
  while read -r line; do
    lines=$((lines + 1))
    if ! cat "$@" | sed 's/^ *//; s/ *$//' | grep -qxF -- "$line"; then
      echo "$page: not in $*: $line" >&2
      exit 1
    fi
  done < <(awk -v block="\`\`\`$language" '/^```/ { inside = $0 == block; next } inside && NF' "$page")
  ((lines > 0))
}

check README.md cpp examples/library_use/draw_mesh.cpp
check docs/library.md cmake tests/package/outside_project/CMakeLists.txt tests/package/added_project/CMakeLists.txt
