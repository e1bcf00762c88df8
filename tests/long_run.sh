#!/usr/bin/env bash
# long_run.sh [MINUTES [FOLDER]]: the tests that find more the longer they run. Every fuzzer runs so many minutes (10) on one processor, the
# geometry fuzzer first; then all tests, with LIGNE_RANDOM_SCENES random scenes (a million) and all views of the models by rays. FOLDER (build/found) collects what the fuzzers find, and
# their corpora, from which the next run goes on. Needs clang. All parts run; the exit status is 1 when one has found something.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
minutes=${1:-10}
found=$(mkdir -p "${2:-$root/build/found}" && cd "${2:-$root/build/found}" && pwd)
cd "$root"
status=0

cmake --preset fuzz
cmake --build --preset fuzz
for fuzzer in geometry gltf glb meshopt obj mtl stl ply off 3mf asc scene tree zbuf grid points hgt tiff formula svg areas drawing; do
  [[ -x build/fuzz/tests/fuzz/fuzz_$fuzzer ]] || continue  # the geometry fuzzer needs CGAL
  case $fuzzer in
    geometry) limits=(-max_len=160 -timeout=60) ;;
    areas) limits=(-max_len=400 -timeout=60) ;;
    *) limits=(-max_len=20000 -timeout=10) ;;
  esac
  mkdir -p "$found/$fuzzer"
  # Crashes are kept, and the run goes on; what is found makes the exit status.
  build/fuzz/tests/fuzz/fuzz_"$fuzzer" -fork=1 -ignore_crashes=1 "${limits[@]}" -rss_limit_mb=2048 -max_total_time=$((60 * minutes)) -print_final_stats=1 \
    -artifact_prefix="$found/$fuzzer-" "$found/$fuzzer" "tests/fuzz/corpus/$fuzzer" || status=1
  [[ -z $(find "$found" -maxdepth 1 -name "$fuzzer-*" -print -quit) ]] || status=1
done

cmake --preset test
cmake --build --preset test
LIGNE_RANDOM_SCENES=${LIGNE_RANDOM_SCENES:-1000000} LIGNE_CHECK_ALL=1 LIGNE_TEST_TIER=all ctest --preset test --parallel "$(nproc)" || status=1
exit $status
