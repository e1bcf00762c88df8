#!/usr/bin/env bash
# bare_root.sh SUITE [COMMAND]: makes a root of Debian (bookworm, trixie) that has nothing but the system, from the machine's own archive,
# runs COMMAND in it as its superuser, and forgets it. /project/ligne.git is there, a repository of the commit that is checked out;
# COMMAND (of bash) starts in /project. Without one, every shell block of the pages is run, from the README's first (tests/docs/run_blocks.sh).
# LIGNE_MODELS_DIR is brought along. LIGNE_CCACHE_DIR names a folder of ccache that the root's builds use and fill, and that outlives it;
# ccache is then installed there too. Needs mmdebstrap.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
suite=${1:?the suite is missing}
command=${2:-"tar -xf pages.tar && LIGNE_MODELS_DIR=/project/models pages/tests/docs/run_blocks.sh --bare /project/ligne.git"}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

git clone -q --bare "file://$root" "$work/ligne.git"
git -C "$root" archive --prefix=pages/ -o "$work/pages.tar" HEAD
mkdir "$work/models"
models=${LIGNE_MODELS_DIR:-$root/../shared/models}
[[ ! -d $models ]] || cp -rL "$models/." "$work/models"
printf '%s\n' 'set -euo pipefail' 'cd /project' "$command" >"$work/command.sh"

# Settings of ccache under which a copy of the project finds what another copy has compiled, whatever their folders.
cache=${LIGNE_CCACHE_DIR:+$(realpath "$LIGNE_CCACHE_DIR")}
run='chroot "$1" env -i PATH="$PATH" HOME=/root LC_ALL=C.UTF-8'
include=() mount_cache=true
if [[ -n $cache ]]; then
  include=(--include=ccache)
  mount_cache="mkdir \"\$1/ccache\" && mount --bind '$cache' \"\$1/ccache\" && trap 'umount -l \"\$1/ccache\"' EXIT"
  run+=' CCACHE_DIR=/ccache CCACHE_BASEDIR=/project CCACHE_NOHASHDIR=1 CMAKE_CXX_COMPILER_LAUNCHER=ccache'
fi

# The hooks get the folder of the root as $1. No service of the packages starts in it.
mmdebstrap --variant=minbase --dpkgopt=force-unsafe-io ${include[@]+"${include[@]}"} --skip=cleanup/apt \
  --customize-hook='mkdir "$1/project"' \
  --customize-hook="copy-in $work/ligne.git $work/pages.tar $work/models $work/command.sh /project" \
  --customize-hook='chown -R root:root "$1/project"' \
  --customize-hook="$mount_cache; $run bash /project/command.sh" \
  "$suite" /dev/null
