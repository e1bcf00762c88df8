#!/usr/bin/env bash
# links_test.sh FOLDER: every link and picture of the Markdown pages leads to a file, and every "#place" to a heading;
# every picture in docs/images is shown on a page, and is not too large. Pages outside (http) are not asked for.
set -euo pipefail
cd "$1"

max_picture=$((300 * 1024)) max_pictures=$((6 * 1024 * 1024))  # a third of it is the gallery of surfaces
failures=0
fail() { echo "$*" >&2; failures=$((failures + 1)); }

pages() { find . -name '*.md' -not -path './build*' -not -path './.git/*' | sort; }

# "LINE TARGET" of every link, picture and HTML picture outside of code blocks.
targets() {
  awk '/^ *```/ { code = !code; next }
       code { next }
       { text = $0
         gsub(/`[^`]*`/, "", text)
         while (match(text, /\]\([^) ]+\)|src="[^"]+"/)) {
           target = substr(text, RSTART, RLENGTH)
           text = substr(text, RSTART + RLENGTH)
           sub(/^\]\(|^src="/, "", target)
           sub(/[)"]$/, "", target)
           print NR, target } }' "$1"
}

# The anchors of a page, as GitHub makes them: lower case, spaces to hyphens, other punctuation left out.
anchors() {
  awk '/^ *```/ { code = !code; next } !code && sub(/^#+ +/, "") { print tolower($0) }' "$1" | sed 's/[^[:alnum:] _-]//g; s/ /-/g'
}

shown=$'\n'
while read -r page; do
  while read -r line target; do
    case $target in http://* | https://* | mailto:*) continue ;; esac
    file=${target%%#*}
    path=$page
    [[ -z $file ]] || path=$(dirname "$page")/$file
    if [[ ! -e $path ]]; then
      fail "$page:$line: there is no $target"
      continue
    fi
    shown+=$(realpath --relative-to=. "$path")$'\n'
    if [[ $target == *#* ]] && ! anchors "$path" | grep -qxF -- "${target#*#}"; then
      fail "$page:$line: $path has no heading for #${target#*#}"
    fi
  done < <(targets "$page")
done < <(pages)

total=0
for picture in docs/images/*; do
  [[ -e $picture ]] || continue
  size=$(stat -c %s "$picture")
  total=$((total + size))
  ((size <= max_picture)) || fail "$picture has $size bytes, more than $max_picture"
  [[ $shown == *$'\n'"$picture"$'\n'* ]] || fail "$picture is on no page"
done
((total <= max_pictures)) || fail "the pictures have $total bytes, more than $max_pictures"
((failures == 0))
