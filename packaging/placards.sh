#!/usr/bin/env bash
# placards.sh FOLDER: gets the pictures of the LaTeX package ghsystem (placards that others drew) into FOLDER, out
# of Debian's texlive-science. That is 4 MB to fetch; installed, it would bring half of TeX.
set -euo pipefail

folder=$(realpath -m "$1")
package=texlive-science
[ -e "$folder/ghsystem_flame.jpg" ] && exit 0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
chmod 755 "$work"
apt-get download -q "$package" >&2
mkdir -p tree "$folder"
dpkg-deb --extract "$package"_*.deb tree
cp tree/usr/share/texlive/texmf-dist/tex/latex/ghsystem/pictures/ghsystem_*.jpg "$folder"
