#!/usr/bin/env bash
# Brings the texts of the window into translations/*.ts: new ones are unfinished there until somebody translates them
# (Qt Linguist, or by hand); tests fail as long as one is.
set -euo pipefail
cd "$(dirname "$0")/.."
for language in de ja; do
    /usr/lib/qt6/bin/lupdate -silent -no-obsolete -locations none -I . app core widgets -extensions cpp,h \
        -tr-function-alias QT_TRANSLATE_NOOP+=translatable \
        -source-language en -target-language "$language" -ts "translations/leitstand_$language.ts" 2>/dev/null
done
