#include "tests/app/plain_tips.h"

#include <algorithm>

#include <QAbstractItemView>
#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QPointer>
#include <QToolTip>

namespace leitstand::test {
namespace {

bool looksRich(const QString& text) {
    return text.contains(QStringLiteral("<b>")) || text.contains(QStringLiteral("<img"));
}

QLabel* shownTip() {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
        if (widget->inherits("QTipLabel") && widget->isVisible()) return qobject_cast<QLabel*>(widget);
    }
    return nullptr;
}

void askAt(QWidget& widget, const QPoint& place, QuotedHtml& found) {
    QHelpEvent ask(QEvent::ToolTip, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &ask);
    if (QLabel* tip = shownTip(); tip != nullptr && looksRich(tip->text())) {
        ++found.tips;
        if (tip->textFormat() != Qt::PlainText) found.drawn << QStringLiteral("tooltip: ") + tip->text();
        tip->hide();
    }
    QToolTip::hideText();
}

void askCells(QAbstractItemView& view, QuotedHtml& found) {
    const QAbstractItemModel* model = view.model();
    if (model == nullptr || !view.isVisible()) return;
    for (int row = 0; row < std::min(model->rowCount(view.rootIndex()), 12); ++row) {
        for (int column = 0; column < model->columnCount(view.rootIndex()); ++column) {
            const QRect place = view.visualRect(model->index(row, column, view.rootIndex()));
            if (place.isValid() && view.viewport()->rect().contains(place.center()))
                askAt(*view.viewport(), place.center(), found);
        }
    }
}

}  // namespace

QuotedHtml quotedHtml(QWidget& window) {
    QuotedHtml found;
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        if (!label->isVisible() || !looksRich(label->text())) continue;
        ++found.labels;
        if (label->textFormat() != Qt::PlainText) found.drawn << QStringLiteral("label: ") + label->text();
    }
    QList<QPointer<QWidget>> widgets;  // a tooltip is a child of what it explains, for a while
    for (QWidget* widget : window.findChildren<QWidget*>()) widgets << widget;
    for (const QPointer<QWidget>& widget : widgets) {
        if (widget.isNull() || widget->inherits("QTipLabel")) continue;
        if (auto* view = qobject_cast<QAbstractItemView*>(widget.data())) askCells(*view, found);
        if (widget->isVisible() && !widget->toolTip().isEmpty())
            askAt(*widget, widget->rect().center(), found);
    }
    return found;
}

}  // namespace leitstand::test
