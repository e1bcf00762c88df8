#!/usr/bin/env bash
# run_blocks.sh LIGNE: runs the shell blocks of the pages in a copy of the project, with LIGNE as the program. Blocks that build, install or
# test are left to
# run_blocks.sh --bare ADDRESS: runs every block, from the first one of the README on, which clones ADDRESS into the folder where the
# script is called, and the others in the clone. It installs packages, and is meant for a root of Debian that has nothing yet
# (scripts/bare_root.sh). Each block must succeed to its last line.
#
# Names that stand for a user's own files (gearbox.obj) are copies of models of ours, or are looked for in LIGNE_MODELS_DIR; a block whose
# files are not there is left out and counted. LIGNE_BLOCKS, a regular expression, chooses blocks by PAGE:LINE.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../.." && pwd)
address='' program=''
if [[ ${1:?the program is missing} == --bare ]]; then address=$(realpath "$2"); else program=$(realpath "$1"); fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Commands that a block may run beyond drawing, and lines that are not run at all: they take hours, or need their own root.
builds='(^|[^-])\b(git clone|apt-get|cmake|ctest|cpack|pkg-config|ninja|pip|python3?)\b|test\.sh|run_blocks|build/'
leave_out='test\.sh --all|ctest --preset (dev|asan-ubsan)|bare_root|release\.sh|fuzz_geometry|run_blocks'

# Files of the user in the commands of the pages, and which of ours stand in for them.
stand_ins='
MODEL.json         examples/models/gear-pair.json
gearbox.obj        examples/models/trefoil.obj
bunny.obj          examples/models/trefoil.obj
room.obj           examples/models/stair-tower.obj
chair.obj          examples/models/five-cubes.obj
lamp.obj           examples/models/trefoil.obj
houses.json        tests/corpus/house.json
places.txt         examples/places.txt
drawing.svg        docs/images/gear-pair.svg
map.svg            docs/images/gear-pair-mesh.svg
wash.svg           docs/images/sombrero.svg
'

# The folder in which the blocks run: a copy of the project, or in a bare root what the first block of the README has cloned.
copy_project() {
  mkdir -p "$work/tree" "$work/bin"
  tar -C "$root" --exclude='./build*' --exclude=./.git --exclude=./dist -cf - . | tar -C "$work/tree" -xf -
  ln -s "$program" "$work/bin/ligne"
  printf '#!/bin/sh\nexec "%s" "$@"\n' "$program" >"$work/tree/ligne.sh"
  chmod +x "$work/tree/ligne.sh"
  cd "$work/tree"
}

models=${LIGNE_MODELS_DIR:-$root/../shared/models}
bring_inputs() {
  local model name stand_in
  if [[ -d $models ]]; then
    for model in "$models"/*; do [[ -e ${model##*/} ]] || ln -s "$model" .; done
    stand_ins+="dem.tif $models/west_bijou_gully.asc"
  fi
  while read -r name stand_in; do
    [[ -z $name || -e $name ]] || cp "$stand_in" "$name"
  done <<<"$stand_ins"
  awk 'BEGIN { print "ncols 40\nnrows 30\nxllcorner 0\nyllcorner 0\ncellsize 10"
               for (i = 0; i < 30; ++i) { for (k = 0; k < 40; ++k) printf "%d ", 700 * exp(-((i - 14) ^ 2 + (k - 20) ^ 2) / 90); print "" } }' >terrain.asc
  printf '[[pen]]\nnumber = 1\nname = "black"\nwidth = 0.5\nrest = true\n' >colours.toml
}

# Blocks as files NUMBER:PAGE:LINE in the order of the pages, with % for the slashes.
mkdir "$work/blocks"
cd "$root"
number=10
for page in README.md CONTRIBUTING.md docs/*.md docs/methods/*.md bench/README.md; do
  number=$((number + 1))
  awk -v name="$work/blocks/$number:${page//\//%}" '
    /^```/ { if (file) { close(file); file = "" } else if (!other && $0 == "```sh") { file = sprintf("%s:%04d", name, NR) } else { other = !other }; next }
    file { print > file }' "$page"
done

shopt -s nullglob
run=0 failed=0 left_out=0
if [[ -z $address ]]; then
  copy_project
  bring_inputs
else
  cd "$OLDPWD"
fi
for block in "$work"/blocks/*; do
  name=${block##*/}
  name=${name#*:}
  name=${name//%//}
  [[ $name =~ ${LIGNE_BLOCKS:-.} ]] || continue
  if [[ -z $address ]] && grep -qE "$builds" "$block"; then continue; fi
  if grep -E "$leave_out" "$block" | sed "s|^|left out: $name: |"; then
    left_out=$((left_out + $(grep -cE "$leave_out" "$block")))
    sed -i -E "/$leave_out/d" "$block"
    [[ -s $block ]] || continue
  fi
  {
    echo 'if ! command -v sudo >/dev/null; then sudo() { "$@"; }; fi'
    sed -E "s/\bMODEL\b/MODEL.json/g; s|\bADDRESS ligne|$address ligne|" "$block"
  } >"$work/script"
  run=$((run + 1))
  if ! PATH=$work/bin:$PATH timeout 3600 bash -euo pipefail "$work/script" >"$work/log" 2>&1 </dev/null; then
    if [[ ! -d $models ]] && missing=$(grep -oE '[^ :]+: there is no such file' "$work/log"); then
      echo "left out: $name: $missing, and there is no LIGNE_MODELS_DIR"
      left_out=$((left_out + 1))
      continue
    fi
    echo "failed: $name"
    sed 's/^/  /' "$block"
    tail -5 "$work/log"
    failed=$((failed + 1))
  fi
  echo "$name: $SECONDS s" >&2
  if grep -q 'git clone' "$block"; then
    cd ligne
    bring_inputs
  fi
done
echo "$run blocks run, $failed failed; $left_out lines or blocks left out"
((run > 0 && failed == 0))
