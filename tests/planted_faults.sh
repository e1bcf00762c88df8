#!/usr/bin/env bash
# planted_faults.sh [FAULT...]: which tests of the first tier notice a fault of the program? In a copy of the tree every patch of
# tests/planted_faults/ is planted by itself, the programs of tests that concern it are built, a part of their first tier is
# run, and a line of a table is printed: fault, and the programs that fail with the number of their failing tests. Fails when a
# fault is noticed by fewer than two programs. Not a part of ctest, since it compiles for many minutes. ccache is used where it
# is installed.
#
#   LIGNE_BUILD_WITH   put before every build, for example "nice" or "flock FILE nice"
#   LIGNE_BUILD_JOBS   compilers at a time; all processors
#   LIGNE_CONFIGURE    more options for cmake
#   LIGNE_WORK         folder for the copy and its build, kept; otherwise a temporary one
#   LIGNE_LEVEL        level of optimization, -O1
#   LIGNE_STOP_AFTER   programs that notice a fault, after which no other is run for it. Each of them stops at its first failing
#                      test, which the table names in place of a number. All programs are run to their ends otherwise
#   LIGNE_TEST_SEED    turns the rotation of the first tier; 0
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
if [[ -n ${LIGNE_WORK:-} ]]; then
  work=$(mkdir -p "$LIGNE_WORK" && cd "$LIGNE_WORK" && pwd)
else
  work=$(mktemp -d)
  trap 'rm -rf "$work"' EXIT
fi
tree=$work/tree build=$work/tree/build/faults logs=$work/logs

# programs_of FAULT: the programs that are run, by what the name of the fault begins with; first those that are likely to
# notice it and quick. PROGRAM/PART is a folder of tests that is run by itself, and counts as a program.
programs_of() {
  case $1 in
    warnock_* | watkins_* | painter_* | bsp_* | newell_* | convex_tree_* | roberts_* | view_*) echo visibility_test methods_test relations_test ;;
    appel_* | zbuffer_*) echo visibility_test cli_test methods_test ;;
    weiler_*) echo visibility_test picture_test methods_test relations_test ;;
    linework_*) echo drawing_test contours_test/clear contours_test/heal picture_test ;;
    contour_*) echo contours_test/clear contours_test/contours contours_test/heal picture_test ;;
    clip_*) echo geometry_test "$(programs_of weiler_)" ;;
    horizon_*) echo visibility_test cli_test ;;
    plot_*) echo plotting_test cli_test ;;
    *) echo fuzz_test relations_test visibility_test methods_test picture_test rays_test ;;
  esac
}

# Small scenes of the corpus that between them have everything.
scenes=(cube cube_on_table plate_one_hole holes_behind_holes cyclic_3_solid cross_of_plates crossing_sheets_joined line_behind_common_side
        same_outline_two_depths peg_in_hole pyramid_in_cube penetrating_plates_with_holes edge_on_face ramp_against_block stair
        thesis_2_73 thesis_2_81c mutual_combs nested_cubes bricks)
each=$(printf ':*/%s' "${scenes[@]}") each_view=$(printf ':*/%s_*' "${scenes[@]}")
# filter_of PROGRAM FAULT: the tests that are run, all where nothing else is said.
filter_of() {
  local general="${each_view#:}${each}:*RandomScenes*:*Crowds*:*Resolution*"
  case $1 in
    methods_test) echo "$general" ;;
    contours_test/clear) echo '*CleanAgain*:ClearAgainstExact*:MadeParts*:MeshSags*' ;;
    contours_test/contours) echo 'ContourSupport*:OutlineProbes*:OutlineGaps*:ShallowIslands*:*ShapeLines*:SmoothContours*:SmoothPatch*:SurfaceFits*:*Surfaces.*' ;;
    contours_test/heal) echo 'ClearDrawing*:Contacts*:Creases*:*Defect*:EdgeTree*:Heal*:SegmentCells*' ;;
    cli_test)
      case $2 in
        appel_*) echo 'DrawTest.*Hidden*' ;;
        horizon_*) echo '*Surface*' ;;
        plot_*) echo '*Plot*' ;;
        zbuffer_*) echo 'ZBufferFile*' ;;
        *) echo '*Surface*:*Plot*:ZBufferFile*' ;;
      esac ;;
    rays_test) echo '*teapot*:*featuretype*:*CITY*' ;;
    *) echo '*' ;;
  esac
}
export LIGNE_TEST_TIER=first LIGNE_TEST_SEED=${LIGNE_TEST_SEED:-0}

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

options=(-DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=${LIGNE_LEVEL:--O1}" -DLIGNE_UNITY=ON -DLIGNE_TESTS=ON -DLIGNE_INSTALL=OFF)
if command -v ccache >/dev/null; then
  options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  export CCACHE_BASEDIR=$tree CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros
fi
# Answers of the oracle are the same with every fault.
export LIGNE_ORACLE_CACHE=$work/oracle_answers
# shellcheck disable=SC2086  # several options
cmake -S "$tree" -B "$build" -G Ninja "${options[@]}" ${LIGNE_CONFIGURE:-} >"$logs/configure" 2>&1 || { cat "$logs/configure" >&2; exit 1; }

# present PROGRAM...: those that are there in this build; some need libraries that are not everywhere.
present() {
  local program
  for program in "$@"; do
    if ninja -C "$build" -t query "${program%/*}" >/dev/null 2>&1; then echo "$program"; fi
  done
}

# build NAME PROGRAM...
build() {
  local name=$1
  shift
  # shellcheck disable=SC2086  # the prefix is several words
  ${LIGNE_BUILD_WITH:-} ninja -C "$build" -j "${LIGNE_BUILD_JOBS:-$(nproc)}" "${@%/*}" >"$logs/$name.build" 2>&1 ||
    { tail -n 30 "$logs/$name.build" >&2; echo "$name does not compile" >&2; exit 1; }
}

# failures FAULT PROGRAM NAME: the program, with the number of its failing tests, when it fails. One that hangs or crashes fails
# too. Its log has the name.
failures() {
  local program=$2 log=$logs/$3.${2/\//.} file failed fast=()
  if [[ -n ${LIGNE_STOP_AFTER:-} ]]; then fast=(--gtest_fail_fast); fi
  file=$(find "$build/tests" -type f -name "${program%/*}" -perm -u+x)
  if timeout 900 "$file" "${fast[@]}" --gtest_filter="$(filter_of "$program" "$1")" --gtest_brief=1 >"$log" 2>&1; then return; fi
  failed=$(sed -nE 's/^\[  FAILED  \] (.*)\([0-9]+ ms\)$/\1/p' "$log" | sed -E 's/, where .*//; s/ *$//')
  if ((${#fast[@]} == 0)); then failed=$(grep -c . <<<"$failed" || true); fi
  if ! grep -q '^\[==========\] .* ran\.' "$log"; then failed="${failed:+$failed, then }stops"; fi
  echo "$program ($failed)"
}

# Patch sets no older time, so that the next build sees that a file is as it was.
plant() { patch -s --no-backup-if-mismatch -d "$tree" -p1 "${@:2}" <"$root/tests/planted_faults/$1.patch"; }

# check_without_fault PROGRAM FAULT: a program that fails without any fault proves nothing. Each selection of tests is run once.
declare -A sound=()
check_without_fault() {
  local program=$1 filter spoilt
  filter=$program\ $(filter_of "$program" "$2")
  if [[ -n ${sound[$filter]:-} ]]; then return; fi
  build none "$program"
  spoilt=$(failures "$2" "$program" none)
  if [[ -n $spoilt ]]; then
    printf 'without any fault this fails, see %s: %s\n' "$logs" "$spoilt" >&2
    exit 1
  fi
  sound[$filter]=1
}

faults=("$@")
if ((${#faults[@]} == 0)); then
  for patch in "$root"/tests/planted_faults/*.patch; do faults+=("$(basename "$patch" .patch)"); done
fi

weak=0
printf '| fault | caught by (failing tests) |\n|---|---|\n'
for fault in "${faults[@]}"; do
  read -ra programs <<<"$(programs_of "$fault")"
  mapfile -t programs < <(present "${programs[@]}")
  stop=${LIGNE_STOP_AFTER:-${#programs[@]}} caught=()
  # Programs are built as they are needed: before the fault is planted those that will be run in any case.
  for program in "${programs[@]:0:stop}"; do check_without_fault "$program" "$fault"; done
  plant "$fault"
  for program in "${programs[@]}"; do
    if [[ -z ${sound[$program $(filter_of "$program" "$fault")]:-} ]]; then
      plant "$fault" -R
      check_without_fault "$program" "$fault"
      plant "$fault"
    fi
    build "$fault" "$program"
    noticed=$(failures "$fault" "$program" "$fault")
    if [[ -n $noticed ]]; then caught+=("$noticed"); fi
    if ((${#caught[@]} >= stop)); then break; fi
  done
  plant "$fault" -R
  # shellcheck disable=SC2016  # the quotes are those of the table
  printf '| `%s` | %s |\n' "$fault" "$(printf '%s\n' "${caught[@]}" | paste -sd, | sed 's/),/), /g')"
  if ((${#caught[@]} < 2)); then
    weak=$((weak + 1))
    echo "$fault is noticed by fewer than two programs" >&2
  fi
done
((weak == 0))
