#!/usr/bin/env bash
# Makes the pictures of README.md and docs/operator.md anew, from the simulated robots: docs/pictures.sh
set -euo pipefail
cd "$(dirname "$0")/.."
program=build/release/bin/leitstand
[[ -x $program ]] || { echo "docs/pictures.sh: $program is not there: run packaging/leitstand run first" >&2; exit 1; }
# A domain of its own, and nothing that somebody's configuration says.
domain=${LEITSTAND_DOMAIN:-101}
XDG_CONFIG_HOME=$(mktemp -d)
export XDG_CONFIG_HOME
trap 'rm -r "$XDG_CONFIG_HOME"' EXIT
for layout in drive explore map; do
    "$program" --demo --domain "$domain" --layout "$layout" --size 1280x800 --screenshot "docs/live-$layout.png"
    echo "docs/live-$layout.png"
done
