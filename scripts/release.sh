#!/usr/bin/env bash
# release.sh [FOLDER]: makes what a release consists of, from the commit that is checked out, in FOLDER (default: dist):
#   ligne-VERSION.tar.gz                  the source, and a Python sdist beside it
#   debian-12/*.deb, debian-13/*.deb      packages, each built, checked by lintian, installed and tried in a root of its own
#   site/                                 the documentation as a static web page
#   SHA256SUMS                            of all files but those of the site
# The roots are made by mmdebstrap, from the machine's own archive; without it the packages are those of this system alone.
# LIGNE_RELEASE_SUITES (default: "bookworm trixie") names others. CONTRIBUTING.md says what comes before and after.
set -euo pipefail

root=$(cd -P "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
cd "$root"
source scripts/setup.sh
mkdir -p "${1:-dist}"
out=$(realpath "${1:-dist}")
version=$(sed -n 's/^project(ligne VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
fail() {
  echo "release: $1" >&2
  exit 1
}

[[ -z $(git status --porcelain) ]] || fail "there are changes that are not committed"
# The system's Python is the one for which setup.sh installs the package that makes the pages.
python=/usr/bin/python3
$python -c 'import markdown, setuptools' || fail "python3-markdown or python3-setuptools is missing"
$python scripts/check_version.py || fail "the version differs from page to page"
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH

archive=$out/ligne-$version.tar.gz
git archive --prefix="ligne-$version/" HEAD | gzip -9n >"$archive"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tar -C "$work" -xf "$archive"

# The commands of the README, in a root or here. Arguments: the folder with the archive, the folder for the packages.
cat >"$work/build_packages.sh" <<'SCRIPT'
set -euo pipefail
cd "$1"
tar -xf ligne-*.tar.gz
cd ligne-*/
cmake -S . -B build/deb -G Ninja -DLIGNE_UNITY=ON -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_SHARED_LIBS=ON -DLIGNE_PYTHON=ON
cmake --build build/deb
(cd build/deb && cpack)
lintian --fail-on error build/deb/*.deb
mkdir -p "$2"
cp build/deb/*.deb "$2"
SCRIPT
cat >"$work/try_packages.sh" <<'SCRIPT'
set -euo pipefail
cd "$1"/ligne-*/
apt-get install -y --no-install-recommends "$2"/*.deb
ligne draw examples/models/gear-pair.json -o /tmp/command.svg
g++ -std=c++20 examples/library_use/list_strokes.cpp -o /tmp/list_strokes $(pkg-config --cflags --libs ligne)
/tmp/list_strokes examples/models/gear-pair.json >/tmp/strokes.txt
[[ -s /tmp/strokes.txt ]]
(cd /tmp && python3 -c 'import ligne, sys; ligne.draw(sys.argv[1]).save("module.svg")' "$OLDPWD/examples/models/gear-pair.json")
cmp /tmp/command.svg /tmp/module.svg
SCRIPT

packages=$(sed 's/^optional //; /^$/d' <<<"$build_packages" | awk '{ printf "%s,", $1 }')
packages+=pybind11-dev,python3-dev,python3-numpy,dpkg-dev,file,lintian
if command -v mmdebstrap >/dev/null 2>&1; then
  declare -A numbers=([bookworm]=12 [trixie]=13)
  for suite in ${LIGNE_RELEASE_SUITES:-bookworm trixie}; do
    folder=$out/debian-${numbers[$suite]:-$suite}
    rm -rf "$folder"
    mkdir -p "$folder"
    # The hooks get the folder of the root as $1.
    mmdebstrap --variant=minbase --include="$packages" --skip=cleanup/apt \
      --customize-hook='mkdir -p "$1/build" "$1/out"' \
      --customize-hook="copy-in $archive $work/build_packages.sh $work/try_packages.sh /build" \
      --customize-hook="chroot \"\$1\" env SOURCE_DATE_EPOCH=$SOURCE_DATE_EPOCH LC_ALL=C.UTF-8 bash /build/build_packages.sh /build /out" \
      --customize-hook='chroot "$1" env LC_ALL=C.UTF-8 bash /build/try_packages.sh /build /out' \
      --customize-hook="sync-out /out $folder" "$suite" /dev/null
  done
else
  echo "release: mmdebstrap is not here; the packages are those of this system alone" >&2
  mkdir -p "$out/debian-local" "$work/here"
  cp "$archive" "$work/here"
  bash "$work/build_packages.sh" "$work/here" "$out/debian-local"
fi

(cd "$work/ligne-$version" && $python setup.py -q sdist --formats=gztar -d "$out/python")
rm -rf "$out/site"
$python scripts/build_site.py "$out/site"
(cd "$out" && find . -type f -not -path './site/*' -not -name SHA256SUMS -printf '%P\n' | sort | xargs sha256sum >SHA256SUMS)
cat "$out/SHA256SUMS"
