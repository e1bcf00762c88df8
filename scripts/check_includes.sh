#!/usr/bin/env bash
# Includes that the build can not forbid, since they stay within one folder's target or name a library from outside:
# parts of src/scene include only those before them, methods only themselves and visibility/common, and oneTBB and CLI11
# are known to the few sources that wrap them. Prints FILE:LINE of every include that breaks a rule.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
broken=0

# forbid WHERE PATTERN [EXCEPT]: no file below WHERE, but those that match EXCEPT, has an include that matches PATTERN.
forbid() {
  local found
  found=$(grep -rnE "^#include [<\"]$2" "$1" --include='*.cpp' --include='*.hpp' | grep -vE "^(${3:-nothing}):" || true)
  if [[ -n $found ]]; then
    printf '%s: may not include %s\n' "$found" "$2"
    broken=1
  fi
}

parts=(model clean heal creases readers surfaces)
for ((i = 0; i < ${#parts[@]}; ++i)); do
  for ((k = i + 1; k < ${#parts[@]}; ++k)); do forbid "src/scene/${parts[i]}" "scene/${parts[k]}/"; done
done
for folder in src/visibility/*/; do
  method=$(basename "$folder")
  for other in src/visibility/*/; do
    other=$(basename "$other")
    [[ $other == "$method" || $other == common ]] || forbid "src/visibility/$method" "visibility/$other/"
  done
done
for folder in src plotting tests bench; do
  forbid "$folder" '(oneapi/)?tbb/' 'src/geometry/parallel\.cpp'
  forbid "$folder" 'CLI/' 'src/cli/(options\.cpp|command_line\.cpp|help\.hpp)'
done
exit "$broken"
