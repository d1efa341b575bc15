#include "widgets/tables/tone_delegate.h"

#include <QGuiApplication>
#include <QSize>

#include "widgets/models/tone.h"

namespace leitstand {
namespace {

constexpr QSize Air(6, 4), AirBesideTickBox(8, 4);  ///< [px]

}  // namespace

QSize ToneDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const bool tickBox = index.data(Qt::CheckStateRole).isValid();
    return QStyledItemDelegate::sizeHint(option, index) + (tickBox ? AirBesideTickBox : Air);
}

void ToneDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
    QStyledItemDelegate::initStyleOption(option, index);
    const auto tone = static_cast<Tone>(index.data(ToneRole).toInt());
    if (tone == Tone::Normal) return;
    // Style sheets set their own colours in the widget's palette, so the application's is used.
    const QColor ink = QGuiApplication::palette().color(tone == Tone::Muted ? QPalette::PlaceholderText
                                                                            : QPalette::BrightText);
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::HighlightedText}) {
        option->palette.setColor(role, ink);
    }
}

}  // namespace leitstand
