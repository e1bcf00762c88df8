#!/usr/bin/env bash
# Includes that the build can not forbid, since they stay within one folder's target or name a library from outside:
# parts of src/scene and of src/visibility include only those before them, methods only themselves and those parts, and oneTBB and
# CLI11 are known to the few sources that wrap them. Prints FILE:LINE of every include that breaks a rule.
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

# in_order FOLDER PART...: each part of the folder includes itself and the parts before it.
in_order() {
  local folder=$1 i k
  shift
  local parts=("$@")
  for ((i = 0; i < ${#parts[@]}; ++i)); do
    for ((k = i + 1; k < ${#parts[@]}; ++k)); do forbid "src/$folder/${parts[i]}" "$folder/${parts[k]}/"; done
  done
}

in_order scene model clean heal creases readers surfaces
shared=(common raster penetration polygons edges order)
in_order visibility "${shared[@]}"
mapfile -t methods < <(cd src/visibility && printf '%s\n' */ | tr -d / | grep -vxF "$(printf '%s\n' "${shared[@]}")")
for method in "${methods[@]}"; do
  for other in "${methods[@]}" "${shared[@]}"; do
    [[ $other == "$method" ]] || forbid "src/visibility/$other" "visibility/$method/"
  done
done
for folder in src plotting studies tests bench; do
  forbid "$folder" '(oneapi/)?tbb/' 'src/base/parallel\.cpp'
  forbid "$folder" 'CLI/' 'src/cli/(options/options\.cpp|command_line\.cpp|help\.hpp)'
done
exit "$broken"
