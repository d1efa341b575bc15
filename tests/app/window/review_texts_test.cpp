#include "tests/app/window/review_page.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

#include "app/language/language.h"
#include "app/window/layouts/layout_feature.h"
#include "tests/app/cut_texts.h"
#include "tests/app/window_size.h"
#include "widgets/map_view/map_view.h"

namespace leitstand::test {
namespace {

/// The review in every language and layout.
class ReviewTexts : public ReviewPage {
protected:
    ~ReviewTexts() override { useLanguage(QStringLiteral("en")); }

    [[nodiscard]] int figures() const { return find<QTableView>("comparisonFigures").model()->rowCount(); }
    void expectWhole(const QString& language, const QString& layout) {
        ASSERT_TRUE(m_window->layouts().use(layout)) << m_window->newest().toStdString();
        EXPECT_TRUE(soon([&] { return m_window->mapView().settled(); }));
        EXPECT_EQ(m_window->size(), windowSize()) << language.toStdString() << ", " << layout.toStdString();
        EXPECT_EQ(cutTexts(*m_window).join(QStringLiteral("; ")).toStdString(), "")
            << language.toStdString() << ", " << layout.toStdString();
        lookAt(QStringLiteral("texts_%1_%2").arg(layout, language));
    }
};

TEST_F(ReviewTexts, WhatIsCutIsSeen) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); }));
    const auto before = cutTexts(*m_window);
    QLabel label(QStringLiteral("far too long"), m_window.get());
    label.setGeometry(0, 0, 20, 20);
    label.show();
    QPushButton button(QStringLiteral("too long with its rim"), m_window.get());
    button.setGeometry(0, 40, button.fontMetrics().horizontalAdvance(button.text()) + 2, 24);
    button.show();
    EXPECT_EQ(cutTexts(*m_window).size(), before.size() + 2)
        << cutTexts(*m_window).join(QStringLiteral("; ")).toStdString();
}

TEST_F(ReviewTexts, FitInEveryLayoutAndLanguage) {
    goTo(47.0);
    for (const char* code : {"en", "de", "ja"}) {
        const QString language = QString::fromLatin1(code);
        useLanguage(language);
        openWindow();
        EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
        ASSERT_EQ(m_window->size(), windowSize());
        ASSERT_EQ(m_window->devicePixelRatioF(), windowScale());
        for (const char* layout : {"drive", "explore", "map", "review", "link", "compare", "report"})
            expectWhole(language, QString::fromLatin1(layout));
        if (figures() > 0) continue;  // the comparison stays when the language changes
        find<QToolButton>("beginComparison").click();
        ASSERT_TRUE(soon([&] { return figures() > 0; })) << m_window->newest().toStdString();
        expectWhole(language, QStringLiteral("compare"));
    }
}

}  // namespace
}  // namespace leitstand::test
