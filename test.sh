#!/usr/bin/env bash
# Builds everything with its tests and runs them. Further arguments go to ctest.
#
#   ./test.sh                                      the first tier: every kind of check, on a part of what can be combined
#   ./test.sh --all                                everything: before a release, and every night
#   ./test.sh -R warnock                           tests whose name matches, whatever the case; or an area: ./test.sh -R cli
#   ./test.sh --gtest_filter='Corpus/AllMethods*'  by GoogleTest's patterns
#
#   LIGNE_TEST_SEED   a number that turns the rotation of the first tier; otherwise it is made of the commit
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
folder=$root/build/release
source "$root/scripts/setup.sh"

tier=first regex='' filter='' arguments=()
while (($# > 0)); do
  case $1 in
    --all) tier=all ;;
    -R | --tests-regex) regex=${2:?the expression is missing} && shift ;;
    --gtest_filter=*) filter=${1#*=} ;;
    *) arguments+=("$1") ;;
  esac
  shift
done

mkdir -p "$folder"
if command -v flock >/dev/null 2>&1; then
  exec 9>"$folder/.ligne-lock"
  flock 9
fi
install_packages "$build_packages$test_packages"
forget_moved_folder "$folder"
build "$folder" all -DLIGNE_TESTS=ON -DLIGNE_PYTHON=ON -DLIGNE_INSTALL=ON -DLIGNE_BENCH=OFF

commit=$(git -C "$root" rev-parse --verify -q HEAD 2>/dev/null || true)
commit=${commit:0:8}
export LIGNE_TEST_TIER=$tier LIGNE_TEST_SEED=${LIGNE_TEST_SEED:-$((16#${commit:-0}))} LIGNE_TEST_COUNTS=$folder/test_counts
rm -f "$LIGNE_TEST_COUNTS"

# Programs of the tests, one per area: "methods path/of/methods_test".
mapfile -t programs <"$folder/test_programs.txt"
if [[ -n $regex || -n $filter ]]; then
  selected=() whole_area=''
  for program in "${programs[@]}"; do
    if [[ ${program%% *} == "$regex" ]]; then whole_area=$regex; fi
  done
  if [[ -n $whole_area && -z $filter ]]; then
    arguments+=(-R "^$whole_area\\.[0-9]+$")
  else
    if [[ -n $regex ]]; then export LIGNE_TEST_REGEX=$regex; fi
    if [[ -n $filter ]]; then export GTEST_FILTER=$filter; fi
    for program in "${programs[@]}"; do
      list=$("${program#* }" --gtest_list_tests)
      if [[ $list == *$'\n  '* ]]; then selected+=("${program%% *}"); fi
    done
    if [[ -n $filter && ${#selected[@]} -eq 0 ]]; then
      echo "test.sh: no test matches $filter${regex:+ and $regex}" >&2
      exit 1
    fi
    names=$(IFS='|' && echo "${selected[*]}")
    arguments+=(-R "${names:+^($names)\\.[0-9]+$}${names:+${regex:+|}}$regex")
  fi
fi

status=0
ctest --test-dir "$folder" --output-on-failure --no-tests=error --parallel "$(nproc 2>/dev/null || echo 1)" \
  ${arguments[@]+"${arguments[@]}"} || status=$?
if [[ -s $LIGNE_TEST_COUNTS ]]; then
  awk -v tier="$tier" -v seed="$LIGNE_TEST_SEED" '
    { tests += $1; failed += $2; skipped += $3; drawings += $4; intervals += $5; pairs += $6 }
    END {
      printf "tier %s, seed %s: %d tests in programs, %d of them failed, %d skipped; ", tier, seed, tests, failed, skipped
      printf "%d drawings held against the oracle, on %d intervals of lines; %d against each other or known answers\n", drawings, intervals, pairs
    }' "$LIGNE_TEST_COUNTS"
fi
exit "$status"
