#!/usr/bin/env bash
# Makes the pictures of README.md and docs/ anew, from the simulated robots and the shipped mission: docs/pictures.sh
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
    "$program" --demo --domain "$domain" --layout "$layout" --size 1280x800 --after 40 \
        --screenshot "docs/live-$layout.png"
    echo "docs/live-$layout.png"
done
sample=resources/samples/yellow-7
"$program" "$sample" --layout review --size 1280x800 --screenshot docs/review.png
echo docs/review.png
# Pages of its report: the map, and the victim.
"${program}ctl" report "$sample" --out "$XDG_CONFIG_HOME/report" >/dev/null
pages=("$XDG_CONFIG_HOME"/report/*.pdf)
for page in map:"map at" victim:"V1.*Victim"; do
    for ((number = 1; number < 20; ++number)); do
        pdftotext -layout -f "$number" -l "$number" "${pages[0]}" - | head -n 3 | grep -q "${page#*:}" || continue
        pdftoppm -r 70 -png -singlefile -f "$number" -l "$number" "${pages[0]}" "docs/report-${page%%:*}"
        echo "docs/report-${page%%:*}.png"
        break
    done
done
