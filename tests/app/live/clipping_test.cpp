#include <map>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QKeySequence>
#include <QLabel>
#include <QMenuBar>
#include <QTextDocument>
#include <QToolButton>

#include <gtest/gtest.h>

#include "app/window/language.h"
#include "app/window/live/layouts/layout_feature.h"
#include "tests/app/live/live_page.h"
#include "widgets/elided_label.h"
#include "widgets/map_view/map_view.h"

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
    return widest(button.fontMetrics(), shownText(button.text())) > button.width();
}

bool isCut(const QComboBox& box) {
    constexpr int Arrow = 18;
    return widest(box.fontMetrics(), box.currentText()) > box.width() - Arrow;
}

/// Texts of @p window that do not fit where they stand.
QStringList cutIn(const QWidget& window) {
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
        if (seen(*label) && !elides && isCut(*label)) cut += name(*label) + ": " + label->text();
    }
    for (const QAbstractButton* button : window.findChildren<QAbstractButton*>())
        if (seen(*button) && isCut(*button)) cut += name(*button) + ": " + button->text();
    for (const QComboBox* box : window.findChildren<QComboBox*>())
        if (seen(*box) && isCut(*box)) cut += name(*box) + ": " + box->currentText();
    for (const QHeaderView* header : window.findChildren<QHeaderView*>()) {
        if (!seen(*header) || header->orientation() != Qt::Horizontal || header->model() == nullptr) continue;
        for (int i = 0; i < header->count(); ++i) {
            const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
            if (!header->isSectionHidden(i) && widest(header->fontMetrics(), text) > header->sectionSize(i))
                cut += name(*header) + ": " + text;
        }
    }
    if (const auto* more = window.findChild<QToolButton*>(QStringLiteral("qt_menubar_ext_button"));
        more != nullptr && more->isVisible())
        cut += QStringLiteral("menus");
    return cut;
}

/// The window in every language and layout.
class LiveTexts : public LivePage {
protected:
    ~LiveTexts() override { useLanguage(QStringLiteral("en")); }
};

TEST_F(LiveTexts, FitInEveryLayoutAndLanguage) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    {
        QLabel narrow(QStringLiteral("far too long"), m_window.get());
        narrow.setGeometry(0, 0, 20, 20);
        narrow.show();
        ASSERT_EQ(cutIn(*m_window).size(), 1) << "what is cut is seen";
    }
    for (const char* language : {"en", "de", "ja"}) {
        useLanguage(QLatin1String(language));
        restart();
        ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        for (const char* layout : {"drive", "explore", "map", "review", "link", "report"}) {
            m_window->layouts().use(QLatin1String(layout));
            EXPECT_TRUE(soon([&] { return m_window->mapView().settled(); }));
            EXPECT_EQ(cutIn(*m_window).join(QStringLiteral("; ")).toStdString(), "")
                << language << ", " << layout;
            lookAt(QStringLiteral("texts_%1_%2").arg(QLatin1String(layout), QLatin1String(language)));
        }
    }
}

TEST_F(LiveTexts, EveryKeyMeansOneThing) {
    std::map<QString, QStringList> meanings;
    for (const QAction* action : m_window->findChildren<QAction*>()) {
        for (const QKeySequence& keys : action->shortcuts()) meanings[keys.toString()] += action->text();
    }
    EXPECT_GT(meanings.size(), 40U);
    for (const auto& [keys, what] : meanings)
        EXPECT_EQ(what.size(), 1) << keys.toStdString() << ": " << what.join(", ").toStdString();
    // Nor do driving, cameras or STOP, which take keys before shortcuts do.
    for (const auto& [keys, what] : meanings) {
        const QKeyCombination pressed = QKeySequence(keys)[0];
        QKeyEvent asked(QEvent::ShortcutOverride, pressed.key(), pressed.keyboardModifiers());
        asked.ignore();
        QApplication::sendEvent(m_window->centralWidget(), &asked);
        EXPECT_FALSE(asked.isAccepted()) << keys.toStdString() << ": " << what.join(", ").toStdString();
    }
    QKeyEvent turns(QEvent::ShortcutOverride, Qt::Key_Q, Qt::ShiftModifier);
    turns.ignore();
    QApplication::sendEvent(m_window->centralWidget(), &turns);
    EXPECT_TRUE(turns.isAccepted()) << "who takes a key is seen";
}

}  // namespace
}  // namespace leitstand::test
