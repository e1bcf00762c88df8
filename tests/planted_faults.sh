#!/usr/bin/env bash
# planted_faults.sh [FAULT...]: which tests notice a fault of the program? In a copy of the tree every patch of tests/planted_faults/ is
# planted by itself, the tests of drawings are built and run, and a line of a table is printed: fault, and the programs that
# fail with the number of their failing tests. Fails when a fault is noticed by fewer than two programs. Not a part of
# ctest, since it compiles for many minutes.
#
#   LIGNE_BUILD_WITH   put before every build, for example "nice" or "flock FILE nice"
#   LIGNE_BUILD_JOBS   compilers at a time; all processors
#   LIGNE_WORK         folder for the copy and its build, kept; otherwise a temporary one
#   LIGNE_LEVEL        level of optimization, -O1
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
if [[ -n ${LIGNE_WORK:-} ]]; then
  work=$LIGNE_WORK
  mkdir -p "$work"
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
tree=$work/tree build=$work/build logs=$work/logs

# Small scenes of the corpus that between them have everything.
scenes=(cube cube_on_table plate_one_hole holes_behind_holes cyclic_3_solid cross_of_plates crossing_sheets_joined line_behind_common_side
        same_outline_two_depths peg_in_hole pyramid_in_cube penetrating_plates_with_holes edge_on_face ramp_against_block stair
        thesis_2_73 thesis_2_81c mutual_combs nested_cubes bricks)
scene_filter=$(printf ':*/%s_*' "${scenes[@]}")
# Programs, those first that are there in every build, with the tests that are run of them.
declare -A filters=(
  [visibility_test]='*' [known_answers_test]='*' [all_methods_test]="${scene_filter#:}" [geometry_replay_test]='*'
  [random_scenes_test]='*' [relations_test]='*' [picture_test]='*' [embree_models_test]='*teapot*:*featuretype*:*CITY*')
programs=(visibility_test known_answers_test all_methods_test geometry_replay_test random_scenes_test relations_test picture_test
          embree_models_test)

# The copy is brought up to date without touching what has not changed, so that it is not compiled again.
mkdir -p "$tree" "$logs"
(cd "$root" && git ls-files -z --cached --others --exclude-standard) |
  while IFS= read -r -d '' file; do
    [[ -f $root/$file ]] || continue
    cmp -s "$root/$file" "$tree/$file" && continue
    mkdir -p "$(dirname "$tree/$file")"
    cp -p "$root/$file" "$tree/$file"
    touch "$tree/$file"
  done
# The models of the tests by rays lie beside the tree.
if [[ -d $root/../shared/models ]]; then
  mkdir -p "$work/shared"
  ln -sfn "$(cd "$root/../shared/models" && pwd)" "$work/shared/models"
fi

cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="${LIGNE_LEVEL:--O1}" >"$logs/configure" 2>&1 ||
  { cat "$logs/configure" >&2; exit 1; }
present=()
for program in "${programs[@]}"; do
  if ninja -C "$build" -t query "$program" >/dev/null 2>&1; then present+=("$program"); fi
done

# build_all NAME
build_all() {
  # shellcheck disable=SC2086  # the prefix is several words
  ${LIGNE_BUILD_WITH:-} ninja -C "$build" -j "${LIGNE_BUILD_JOBS:-$(nproc)}" "${present[@]}" >"$logs/$1.build" 2>&1 ||
    { tail -n 30 "$logs/$1.build" >&2; echo "$1 does not compile" >&2; exit 1; }
}

# caught_by NAME: the programs that fail, with the number of their failing tests. A program that hangs or crashes fails too.
caught_by() {
  local program log file
  for program in "${present[@]}"; do
    log=$logs/$1.$program
    file=$(find "$build/tests" -type f -name "$program" -perm -u+x)
    if timeout 900 "$file" --gtest_filter="${filters[$program]}" --gtest_brief=1 >"$log" 2>&1; then continue; fi
    printf '%s %s\n' "$program" "$(grep -c '^\[  FAILED  \] .*(' "$log" || true)"
  done
}

build_all none
spoilt=$(caught_by none)
if [[ -n $spoilt ]]; then
  printf 'without any fault these fail, see %s:\n%s\n' "$logs" "$spoilt" >&2
  exit 1
fi

faults=("$@")
if ((${#faults[@]} == 0)); then
  for patch in "$root"/tests/planted_faults/*.patch; do faults+=("$(basename "$patch" .patch)"); done
fi
weak=0
printf '| fault | caught by (failing tests) |\n|---|---|\n'
for fault in "${faults[@]}"; do
  patch=$root/tests/planted_faults/$fault.patch
  patch -s -d "$tree" -p1 <"$patch"
  build_all "$fault"
  caught=$(caught_by "$fault")
  patch -s -R -d "$tree" -p1 <"$patch"
  # Patch sets no older time, so that the next build sees that the file is as it was.
  printf '| %s | %s |\n' "$fault" "$(sed -E 's/^([^ ]+) (.*)$/\1 (\2)/' <<<"$caught" | paste -sd, | sed 's/,/, /g')"
  if (($(grep -c . <<<"$caught" || true) < 2)); then
    weak=$((weak + 1))
    echo "$fault is noticed by fewer than two programs" >&2
  fi
done
((weak == 0))
