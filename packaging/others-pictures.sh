#!/usr/bin/env bash
# others-pictures.sh KIND FOLDER: gets pictures that others made into FOLDER, out of a Debian package that is fetched and
# not installed. KIND is
#   placards  placards and pictograms of the LaTeX package ghsystem: texlive-science, 4 MB; installed, it brings half of TeX
#   film      people walking before a camera at rest (vtest.avi of OpenCV): opencv-doc, 92 MB
set -euo pipefail

case "${1:-}" in
placards) package=texlive-science files='usr/share/texlive/texmf-dist/tex/latex/ghsystem/pictures/ghsystem_*.jpg' ;;
film) package=opencv-doc files='usr/share/doc/opencv-doc/examples/data/vtest.avi' ;;
*) printf 'usage: %s placards|film FOLDER\n' "$0" >&2 && exit 2 ;;
esac
folder=$(realpath -m "${2:?FOLDER is missing}")
[ -e "$folder/complete" ] && exit 0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
chmod 755 "$work"
apt-get download -q "$package" >&2
mkdir -p tree "$folder"
dpkg-deb --fsys-tarfile "$package"_*.deb | tar -x -C tree --wildcards "./$files"
cp tree/$files "$folder"
touch "$folder/complete"
