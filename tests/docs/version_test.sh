#!/usr/bin/env bash
# version_test.sh FOLDER: the version is one everywhere, and check_version.py finds where it is not.
set -euo pipefail
check=$1/scripts/check_version.py
python3 "$check" "$1"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir "$folder/docs"
for file in CMakeLists.txt CHANGELOG.md CITATION.cff README.md docs/library.md; do cp "$1/$file" "$folder/$file"; done
python3 "$check" "$folder"
for file in CHANGELOG.md CITATION.cff README.md docs/library.md; do
  sed -i 's/0\.2/0.1/' "$folder/$file"
  if python3 "$check" "$folder" 2>/dev/null; then
    echo "a wrong version in $file is not found" >&2
    exit 1
  fi
  cp "$1/$file" "$folder/$file"
done
