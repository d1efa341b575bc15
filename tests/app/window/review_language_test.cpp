#include "tests/app/window/review_page.h"

#include <filesystem>

#include <QAction>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"

namespace leitstand::test {
namespace {

/// The language chosen during a review.
class ReviewLanguage : public ReviewPage {
protected:
    ~ReviewLanguage() override { useLanguage(QStringLiteral("en")); }
    [[nodiscard]] std::string textOf(const char* id) const {
        return m_window->commands().find(QLatin1String(id))->text().toStdString();
    }
};

TEST_F(ReviewLanguage, TheWindowIsMadeAnewWhereTheReviewStandsAndItsReportGoesOn) {
    goTo(33.0);
    const std::string before = textOf("review.registerAgain");
    EXPECT_EQ(before, "&Register again…");
    QString wanted;
    QObject::connect(m_window.get(), &ReviewWindow::languageWanted, m_window.get(),
                     [&](const QString& code) { wanted = code; });
    const std::filesystem::path out = m_folder / "hand-in";
    m_bridge->reportInto(QString::fromStdString(out.string()));
    m_window->commands().trigger(QStringLiteral("language.de"));
    ASSERT_EQ(wanted.toStdString(), "de");
    ASSERT_TRUE(useLanguage(wanted));
    openWindow();
    EXPECT_NE(textOf("review.registerAgain"), before);
    EXPECT_TRUE(m_window->commands().find(QStringLiteral("language.de"))->isChecked());
    EXPECT_TRUE(stands(33.0)) << "the review stays where it was";
    EXPECT_TRUE(soon([&] { return std::filesystem::exists(out / "SHA256SUMS"); }))
        << m_window->newest().toStdString();
    EXPECT_TRUE(soon([&] { return m_window->newest().contains(QString::fromStdString(out.string())); }));
}

}  // namespace
}  // namespace leitstand::test
