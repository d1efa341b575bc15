#!/usr/bin/env bash
# Brings the texts of the window into translations/*.ts: new ones are unfinished there until somebody translates them
# (Qt Linguist, or by hand); tests fail as long as one is. With the code of a language, fr, makes its file as well.
set -euo pipefail
cd "$(dirname "$0")/.."
for file in translations/leitstand_*.ts ${1:+"translations/leitstand_$1.ts"}; do
    language=${file#translations/leitstand_}
    language=${language%.ts}
    /usr/lib/qt6/bin/lupdate -silent -no-obsolete -locations none -I . app core widgets -extensions cpp,h \
        -tr-function-alias QT_TRANSLATE_NOOP+=translatable \
        -source-language en -target-language "$language" -ts "$file" 2>/dev/null
done
