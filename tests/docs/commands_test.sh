#!/usr/bin/env bash
# commands_test.sh LIGNE: the commands of the pages succeed; in the first tier those of the README.
set -euo pipefail
if [[ ${LIGNE_TEST_TIER:-} != all ]]; then export LIGNE_BLOCKS=${LIGNE_BLOCKS:-^README}; fi
exec "$(dirname "${BASH_SOURCE[0]}")/run_blocks.sh" "$1"
