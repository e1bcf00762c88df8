#!/usr/bin/env bash
# Runs ligne with the arguments given. Installs the packages and builds the program first, where that is still to be done.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")" && pwd)
folder=$root/build/release
program=$folder/src/cli/ligne
# The experiments are a program of their own, built when they are first asked for.
target=ligne
if [[ ${1-} == study ]]; then target=ligne-study; fi
sources=("$root/src" "$root/plotting" "$root/cmake" "$root/CMakeLists.txt" "$root/scripts/setup.sh" "$root/studies")

# Nothing that the build reads is newer than the last build of the target, or of all of them. A folder is newer when a file in it
# came or went.
is_built() {
  [[ -x $program && -x ${program%/*}/$target ]] || return 1
  local stamp
  for stamp in "$folder/.built-$target" "$folder/.built-all"; do
    [[ -e $stamp && -z $(find "${sources[@]}" -newer "$stamp" -print -quit) ]] && return 0
  done
  return 1
}

cannot_build() {
  echo "ligne.sh: $folder: can not be written, and the program in it is $1; build it as somebody who may, or in a copy" >&2
  exit 1
}

if ! is_built; then
  state="not built"
  [[ -x $program ]] && state="older than its sources"
  # To make the folder and to write into it are two things that can be forbidden.
  { mkdir -p "$folder" && : >>"$folder/.ligne-lock"; } 2>/dev/null || cannot_build "$state"
  (
    # Two runs at once build once.
    if command -v flock >/dev/null 2>&1; then
      exec 9>"$folder/.ligne-lock"
      flock 9
    fi
    source "$root/scripts/setup.sh"
    if ! is_built; then
      install_packages "$build_packages"
      forget_moved_folder "$folder"
      # Where test.sh has configured the folder, it stays as it is: the objects are the same.
      options=()
      if [[ ! -e $folder/CMakeCache.txt ]]; then
        options=(-DLIGNE_TESTS=OFF -DLIGNE_PYTHON=OFF -DLIGNE_BENCH=OFF -DLIGNE_INSTALL=OFF)
      fi
      build "$folder" "$target" ${options[@]+"${options[@]}"}
    fi
  )
fi
exec "$program" "$@"
