#!/usr/bin/env bash
# options_test.sh FOLDER LIGNE: docs/options.md names every option that the help names, and no other; the commands of the
# README and of the gallery are accepted as far as their options go.
set -euo pipefail
folder=$1 ligne=$2
page=$folder/docs/options.md

long_options() { grep -oE -- '(^|[^-[:alnum:]])--[a-z][a-z-]*' | grep -oE -- '--[a-z-]+' | sort -u; }
of_help=$( { "$ligne" --help; for command in draw surface plot info compare methods devices study; do "$ligne" help "$command" all; done; } | long_options)
of_page=$(long_options <"$page")
if ! difference=$(diff <(echo "$of_help") <(echo "$of_page")); then
  echo "options of the help (<) and of docs/options.md (>) differ:" >&2
  echo "$difference" >&2
  exit 1
fi

unknown=$(grep -hoE '^(\./ligne\.sh|ligne|      ) .*' "$folder/README.md" "$folder/docs/gallery.md" "$folder/docs/surfaces-gallery.md" | sed 's/#.*//' | long_options |
          comm -23 - <(echo "$of_help"))
if [[ -n $unknown ]]; then
  echo "README.md or docs/gallery.md use unknown options:" $unknown >&2
  exit 1
fi
