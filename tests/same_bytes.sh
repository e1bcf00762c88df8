#!/usr/bin/env bash
# same_bytes.sh OLD NEW: do two builds of the program write the same? Runs both on the commands of the documentation's
# pictures, on every scene of the corpus and every model by every method, and on surfaces and plots, and compares files,
# messages and exit statuses byte by byte. For changes that are to leave every drawing as it is; not a part of ctest,
# since it needs the program of before. Programs that know --quality draw with --quality exact, so that one from before
# clear lines can be compared with one of today; LIGNE_QUALITY=clear leaves them as they are.
#
#   LIGNE_MODELS_DIR   folder of models (default: ../shared/models beside the tree, where it is there)
#   LIGNE_SECONDS      most seconds for one command, 60; one that needs more is reported and left out
set -euo pipefail

root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
models=${LIGNE_MODELS_DIR:-$root/../shared/models}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/old" "$work/new"

# exact_program PROGRAM WRAPPER: a program that draws exact lines unless others are asked for, whether PROGRAM knows of
# others or not.
exact_program() {
  local program=$1 option=
  if grep -q -- '--quality' <<<"$("$program" draw --help)"; then option='--quality exact'; fi
  cat >"$2" <<END
#!/bin/sh
case " \$* " in
  *" --quality"*) ;;
  " draw "* | " info "*) exec "$program" "\$@" $option ;;
esac
exec "$program" "\$@"
END
  chmod +x "$2"
}
old=$(realpath "$1") new=$(realpath "$2")
if [[ ${LIGNE_QUALITY:-exact} == exact ]]; then
  exact_program "$old" "$work/ligne-old"
  exact_program "$new" "$work/ligne-new"
  old=$work/ligne-old new=$work/ligne-new
fi
compared=0 different=0 slow=0

# same NAME ARGUMENT...: runs both programs, each in a folder of its own, and compares what they leave behind.
same() {
  local name=$1 side program status
  shift
  for side in old new; do
    program=${!side}
    status=0
    (cd "$work/$side" && timeout "${LIGNE_SECONDS:-60}" "$program" "$@" >out.txt 2>err.txt) || status=$?
    if ((status == 124)); then
      slow=$((slow + 1))
      echo "too slow: ligne $*"
      rm -f "$work/old/"* "$work/new/"*
      return
    fi
    echo "$status" >"$work/$side/status.txt"
  done
  compared=$((compared + 1))
  if ! diff -rq "$work/old" "$work/new" >"$work/diff"; then
    different=$((different + 1))
    echo "different ($name): ligne $*"
    sed "s|$work/||g; s/^/  /" "$work/diff"
  fi
  rm -f "$work/old/"* "$work/new/"*
}

mapfile -t methods < <("$old" methods --json | sed -n 's/.*"name": "\([^"]*\)".*/\1/p')

# The documentation's pictures.
"$root/docs/make_images.sh" "$old" "$work/images-old" >/dev/null
"$root/docs/make_images.sh" "$new" "$work/images-new" >/dev/null
if ! diff -rq "$work/images-old" "$work/images-new"; then different=$((different + 1)); fi
compared=$((compared + $(find "$work/images-old" -type f | wc -l)))

scenes=("$root"/tests/corpus/*.json)
if [[ -d $models ]]; then
  mapfile -t -O "${#scenes[@]}" scenes < <(find "$models" -type f \( -name '*.obj' -o -name '*.stl' -o -name '*.ply' -o -name '*.gl*' -o -name '*.ASC' \) | sort)
fi
for scene in "${scenes[@]}"; do
  for method in "${methods[@]}"; do
    same "$method" draw "$scene" --method "$method" -o out.svg
    [[ $scene == */corpus/* ]] && same "$method" draw "$scene" --method "$method" --eye 9,-7,8 --edges all --hidden dashed -o out.json
  done
  same regions draw "$scene" --hatch shade --hatch-angle face --light 1,2,-3 -o out.svg
  same info info "$scene" --json
done
box=$root/tests/corpus/penetrating_plates_with_holes.json
for suffix in svg pdf png json hpgl gcode; do same "$suffix" draw "$box" -o "out.$suffix"; done
for view in front back left right top bottom iso dimetric trimetric; do same "$view" draw "$box" --view "$view" --cull --fill shade -o out.pdf; done
for formula in 'sin(x*y)' 'sin(r)/r' 'x<y?1:0' 'sqrt(9-x^2-y^2)'; do
  same surface surface "$formula" -x -3:3:20 -y -3:3:20 --axes --title t -o out.svg
  same mesh surface "$formula" -x -3:3:20 -y -3:3:20 --hidden dashed --contours 5 --axes=grid -o out.pdf
  same hatched surface "$formula" -x -3:3:20 -y -3:3:20 --hatch shade -o out.hpgl
done
for drawing in "$root"/docs/images/{gear-pair,sombrero,trefoil}.svg; do
  same plot plot "$drawing" --device hp7475a --fit-device --report -o out.hpgl
  same plot plot "$drawing" --page A3 --scale fit -o out.svg
done
same error draw /nowhere.obj -o out.svg
same error draw "$box" --method nonsense -o out.svg
same error draw "$box" --margin 200 -o out.svg
same help draw --help
same help surface --help
same methods methods --json

echo "$compared compared, $different different, $slow too slow"
((different == 0))
