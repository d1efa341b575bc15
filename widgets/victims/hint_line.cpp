#include "widgets/victims/hint_line.h"

#include <QEvent>
#include <QStyle>
#include <QStyleOptionFrame>

#include "widgets/models/victims/victim_choices.h"

namespace leitstand {
namespace {

constexpr int Margins = 8;  ///< around the text of a QLineEdit, besides its style's [px]

}  // namespace

void HintLine::setHints(const QStringList& words, bool more) {
    m_words = words;
    m_more = more;
    fit();
}

void HintLine::fit() {
    QStyleOptionFrame option;
    initStyleOption(&option);
    const QRect room = style()
                           ->subElementRect(QStyle::SE_LineEditContents, &option, this)
                           .marginsRemoved(textMargins())
                           .adjusted(0, 0, -Margins, 0);
    QString shown;
    for (auto count = m_words.size(); count > 0 && shown.isEmpty(); --count) {
        const QStringList words = m_words.first(count);
        const bool more = m_more || count < m_words.size();
        for (const QString& text : {hintText(words, more), hintText(words, false)}) {
            if (shown.isEmpty() && fontMetrics().horizontalAdvance(text) <= room.width()) shown = text;
        }
    }
    if (shown != placeholderText()) setPlaceholderText(shown);
}

void HintLine::resizeEvent(QResizeEvent* event) {
    QLineEdit::resizeEvent(event);
    fit();
}

void HintLine::changeEvent(QEvent* event) {
    QLineEdit::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) fit();
}

}  // namespace leitstand
