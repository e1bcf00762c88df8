#!/usr/bin/env bash
# Makes the pictures of docs/tour.md, docs/gallery.md, docs/clear-lines.md, docs/shape-lines.md, docs/subdivision.md, docs/surfaces.md, docs/surfaces-gallery.md and docs/methods anew, by the very commands that stand there: docs/make_images.sh [LIGNE [FOLDER]]
# LIGNE is the program (default: ligne.sh, which builds it), FOLDER where the pictures go (default: docs/images).
# Models and grids that others made are looked for in LIGNE_MODELS_DIR; pictures of those that are not there stay as they are.
# White paper is put under each drawing, so that it can be read on dark screens too.
set -euo pipefail

root=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
ligne=$(realpath "${1:-$root/ligne.sh}")
mkdir -p "${2:-$root/docs/images}"
folder=$(realpath "${2:-$root/docs/images}")
cd "$root"

# The commands of the pages: lines of its sh blocks that draw into docs/images, with their continuation lines.
commands() {
  awk '/^```/ { inside = $0 == "```sh"; next }
       inside { line = line $0; if (sub(/\\$/, "", line)) next; if (line ~ /^ligne (draw|surface) .* -o docs\/images\//) print line; line = "" }' \
    docs/tour.md docs/gallery.md docs/clear-lines.md docs/shape-lines.md docs/subdivision.md docs/surfaces.md docs/surfaces-gallery.md docs/methods/*.md
}

made=0
while read -r line; do
  eval "words=($line)"  # quotes as in a shell; the lines are our own
  for i in "${!words[@]}"; do
    [[ ($i -gt 0 && ${words[i - 1]} == --grid) || ($i == 2 && ${words[1]} == draw) ]] || continue
    [[ -f ${words[i]} ]] || words[i]=${LIGNE_MODELS_DIR:-.}/${words[i]}
    [[ -f ${words[i]} ]] || { echo "left out, ${words[i]} is not there: $line"; continue 2; }
  done
  picture=$folder/${words[-1]#docs/images/}
  "$ligne" "${words[@]:1:${#words[@]}-2}" "$picture"
  sed -i 's|^<svg .*>$|&\n<rect width="100%" height="100%" fill="#fff"/>|' "$picture"
  made=$((made + 1))
done < <(commands)
echo "$made pictures in $folder"
((made > 0))
