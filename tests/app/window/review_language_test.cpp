#include "tests/app/window/review_page.h"

#include <filesystem>

#include <QAction>

#include <gmock/gmock.h>

#include "app/language/language.h"
#include "app/window/commands/command_table.h"
#include "app/window/source/review_report.h"
#include "tests/support/others_tools.h"

namespace leitstand::test {
namespace {

/// The language chosen during a review.
class ReviewLanguage : public ReviewPage {
protected:
    ~ReviewLanguage() override { useLanguage(QStringLiteral("en")); }
    [[nodiscard]] std::string textOf(const char* id) const {
        return m_window->commands().find(QLatin1String(id))->text().toStdString();
    }
    [[nodiscard]] static std::filesystem::path pdfIn(const std::filesystem::path& folder) {
        for (const auto& one : std::filesystem::directory_iterator(folder)) {
            if (one.path().extension() == ".pdf") return one.path();
        }
        return folder / "no.pdf";
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
    ASSERT_TRUE(soon([&] { return m_bridge->report().writing(); }));
    m_bridge->report().beginAround([&] { ASSERT_TRUE(useLanguage(wanted)); });
    openWindow();
    EXPECT_NE(textOf("review.registerAgain"), before);
    EXPECT_TRUE(m_window->commands().find(QStringLiteral("language.de"))->isChecked());
    EXPECT_TRUE(stands(33.0)) << "the review stays where it was";
    EXPECT_TRUE(soon([&] { return std::filesystem::exists(out / "SHA256SUMS"); }))
        << m_window->newest().toStdString();
    ASSERT_TRUE(soon([&] {
        return m_window->newest().contains(QString::fromStdString(out.string())) &&
               !m_bridge->report().writing();
    }));
    const ProcessOutcome printed = readByPoppler(pdfIn(out));
    LEITSTAND_NEEDS(printed);
    EXPECT_THAT(printed.out, testing::HasSubstr("Opfer"));
    EXPECT_THAT(printed.out, testing::Not(testing::HasSubstr("Victim"))) << "one language, the last one";
}

}  // namespace
}  // namespace leitstand::test
