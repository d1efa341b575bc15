#include "tests/app/cut_texts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QComboBox>
#include <QCoreApplication>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>
#include <QStyleOptionFrame>
#include <QTabBar>
#include <QTextDocument>
#include <QToolButton>

#include "tests/widgets/panes/shown.h"
#include "widgets/painting/elided_label.h"

namespace leitstand::test {
namespace {

QString shownText(const QString& text) {
    if (!Qt::mightBeRichText(text)) return QString(text).remove(QLatin1Char('&'));
    QTextDocument document;
    document.setHtml(text);
    return document.toPlainText();
}

int widest(const QFontMetrics& metrics, const QString& text) {
    int most = 0;
    for (const QString& line : text.split(QLatin1Char('\n')))
        most = std::max(most, metrics.horizontalAdvance(line));
    return most;
}

bool isCut(const QLabel& label) {
    const QString text = shownText(label.text());
    if (text.trimmed().isEmpty() || !label.pixmap().isNull()) return false;
    const QSize room = label.contentsRect().size();
    if (label.wordWrap()) return label.heightForWidth(label.width()) > label.height() + 2;
    return widest(label.fontMetrics(), text) > room.width() + 1;
}

bool isCut(const QAbstractButton& button) {
    const auto* tool = qobject_cast<const QToolButton*>(&button);
    if (button.text().isEmpty() || (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly))
        return false;
    // What dresses a button needs room too.
    if (tool != nullptr || qobject_cast<const QPushButton*>(&button) != nullptr)
        return button.sizeHint().width() > button.width();
    return widest(button.fontMetrics(), shownText(button.text())) > button.width();
}

/// Whether what @p widget is laid into shows only a part of it. What can be scrolled into sight is not cut.
bool isCovered(const QWidget& widget) {
    constexpr int Rim = 2;  ///< may be missing [px]
    QRect shown = widget.rect();
    for (const QWidget* in = widget.parentWidget(); in != nullptr; in = in->parentWidget()) {
        if (qobject_cast<const QAbstractScrollArea*>(in) != nullptr) return false;
        const QPoint corner = widget.mapTo(in, QPoint());
        shown &= in->rect().translated(-corner);
        if (in->isWindow()) break;
    }
    return shown.width() < widget.width() - Rim || shown.height() < widget.height() - Rim;
}

bool isCut(const QComboBox& box) {
    constexpr int Arrow = 18;
    return widest(box.fontMetrics(), box.currentText()) > box.width() - Arrow;
}

/// Of what a line says as long as nothing is written into it.
bool isCut(const QLineEdit& line) {
    constexpr int Margins = 4;  ///< at least, that a line keeps around its text [px]
    QStyleOptionFrame option;
    option.initFrom(&line);
    option.rect = line.contentsRect();
    option.lineWidth =
        line.hasFrame() ? line.style()->pixelMetric(QStyle::PM_DefaultFrameWidth, nullptr, &line) : 0;
    option.state |= QStyle::State_Sunken;
    const int room = line.style()->subElementRect(QStyle::SE_LineEditContents, &option, &line).width();
    return line.text().isEmpty() && widest(line.fontMetrics(), line.placeholderText()) > room - Margins;
}

/// What is painted of @p window, whole lines: where a font has not all letters, a line is painted in pieces.
std::vector<PaintedText> paintedLines(const QWidget& window) {
    constexpr double Near = 1.5;  ///< [px]
    std::vector<PaintedText> lines;
    for (const PaintedText& one : paintedTexts(const_cast<QWidget&>(window))) {  // painting changes nothing
        const bool goesOn = !lines.empty() && std::abs(lines.back().box.right() - one.box.left()) < Near &&
                            one.box.top() < lines.back().box.bottom() &&
                            one.box.bottom() > lines.back().box.top();
        if (!goesOn) {
            lines.push_back(one);
            continue;
        }
        lines.back().text += one.text;
        lines.back().box |= one.box;
    }
    return lines;
}

/// Texts, also of cells, that end in dots where they are painted, and not where they come from.
QStringList dottedTexts(const QWidget& window) {
    constexpr QChar Dots(0x2026);
    QStringList whole;
    const auto add = [&](const QString& text) {
        if (text.contains(Dots)) whole += shownText(text);
    };
    for (const QLabel* label : window.findChildren<QLabel*>()) add(label->text());
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>()) add(button->text());
    for (const QLineEdit* line : window.findChildren<QLineEdit*>()) add(line->placeholderText());
    for (const QAction* action : window.findChildren<QAction*>()) add(action->text());
    // The newest message gives way to menus and badges; its tooltip has all of it.
    const auto* message = window.findChild<QLabel*>(QStringLiteral("word"));
    const auto isMessage = [&](const QString& painted) {
        return message != nullptr && painted.endsWith(Dots) && message->text().contains(painted.chopped(1)) &&
               message->toolTip().simplified().contains(message->text().simplified());
    };
    QStringList cut;
    for (const PaintedText& one : paintedLines(window)) {
        const bool fromThere = std::any_of(whole.begin(), whole.end(),
                                           [&](const QString& text) { return text.contains(one.text); });
        if (one.text.contains(Dots) && !fromThere && !isMessage(one.text))
            cut += QStringLiteral("painted: ") + one.text;
    }
    return cut;
}

}  // namespace

QStringList cutTexts(const QWidget& window) {
    // A text that has just changed has its room only after it is laid out.
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QStringList cut;
    const auto name = [](const QWidget& widget) {
        const QString own = widget.objectName().isEmpty() ? widget.accessibleName() : widget.objectName();
        return QString::fromLatin1(widget.metaObject()->className()) + QLatin1Char(' ') + own;
    };
    const auto seen = [](const QWidget& widget) {
        // What can be scrolled into sight is not cut.
        return widget.isVisible() && !widget.visibleRegion().isEmpty();
    };
    for (const QLabel* label : window.findChildren<QLabel*>()) {
        const bool elides = label->objectName() == QStringLiteral("word") ||  // the whole is its tooltip
                            qobject_cast<const ElidedLabel*>(label) != nullptr;
        if (seen(*label) && !elides && (isCut(*label) || isCovered(*label)))
            cut += name(*label) + ": " + label->text();
    }
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        if (seen(*button) && (isCut(*button) || isCovered(*button)))
            cut += name(*button) + ": " + button->text();
    for (const QComboBox* box : window.findChildren<QComboBox*>())
        if (seen(*box) && isCut(*box)) cut += name(*box) + ": " + box->currentText();
    for (const QLineEdit* line : window.findChildren<QLineEdit*>())
        if (seen(*line) && isCut(*line)) cut += name(*line) + ": " + line->placeholderText();
    for (const QHeaderView* header : window.findChildren<QHeaderView*>()) {
        if (!seen(*header) || header->orientation() != Qt::Horizontal || header->model() == nullptr) continue;
        for (int i = 0; i < header->count(); ++i) {
            const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
            if (!header->isSectionHidden(i) && widest(header->fontMetrics(), text) > header->sectionSize(i))
                cut += name(*header) + ": " + text;
        }
    }
    for (const QTabBar* bar : window.findChildren<QTabBar*>()) {
        if (!seen(*bar)) continue;
        for (int i = 0; i < bar->count(); ++i) {
            const QString text = shownText(bar->tabText(i));
            if (bar->isTabVisible(i) && widest(bar->fontMetrics(), text) > bar->tabRect(i).width())
                cut += name(*bar) + ": " + text;
        }
    }
    if (const auto* more = window.findChild<QToolButton*>(QStringLiteral("qt_menubar_ext_button"));
        more != nullptr && more->isVisible())
        cut += QStringLiteral("menus");
    return cut + dottedTexts(window);
}

}  // namespace leitstand::test
