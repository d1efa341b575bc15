#include <chrono>
#include <filesystem>
#include <system_error>

#include <QAction>
#include <QFileDialog>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include "app/services/handin/writing/report_folder.h"
#include "app/services/handin/writing/report_keeper.h"
#include "app/window/commands/command_table.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/panes/score/report_feature.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds Often(300);

/// The hand-in of a mission that is being recorded, by the real widgets.
class LiveReport : public LivePage {
protected:
    [[nodiscard]] ReportFeature& feature() const { return *m_window->findChild<ReportFeature*>(); }
    [[nodiscard]] QAction& keeping() const { return *m_window->commands().find("mission.report"); }
    /// As chosen in the dialog, which the platform may draw.
    void choose(const fs::path& folder) {
        auto* dialog = m_window->findChild<QFileDialog*>("reportFolder");
        ASSERT_NE(dialog, nullptr);
        EXPECT_FALSE(dialog->isModal()) << "robots drive meanwhile";
        emit dialog->fileSelected(QString::fromStdString(folder.string()));
        dialog->close();
    }
    /// When the newest report was written whole; the list of its files comes last.
    [[nodiscard]] fs::file_time_type written() const {
        std::error_code none;
        return fs::last_write_time(m_out / "SHA256SUMS", none);
    }
    [[nodiscard]] bool isThere() const { return fs::exists(m_out / "SHA256SUMS"); }

    const fs::path m_out = fs::path(m_folder.path().toStdString()) / "hand-in";
};

TEST_F(LiveReport, OneButtonWritesItAndItIsWrittenAgainUntilTheButtonIsPressedOnceMore) {
    EXPECT_EQ(feature().interval(), std::chrono::minutes(1));
    EXPECT_EQ(ReportKeeper::Settings().interval, std::chrono::minutes(1));
    m_window->layouts().use("report");
    auto* button = m_window->findChild<QToolButton*>("mission.report");
    ASSERT_NE(button, nullptr);
    ASSERT_TRUE(soon([&] { return !button->visibleRegion().isEmpty(); }));
    EXPECT_EQ(button->text().toStdString(), "Report");
    button->click();
    EXPECT_FALSE(keeping().isChecked()) << "no folder is chosen yet";
    choose(m_out);
    EXPECT_TRUE(button->isChecked());
    ASSERT_TRUE(soon([&] { return isThere(); })) << m_window->newest().toStdString();
    EXPECT_TRUE(soon([&] {
        return m_window->recent().join(";").contains("competition or team are not given");
    })) << "what is missing in it is said";
    const auto first = written();
    feature().setInterval(Often);
    EXPECT_TRUE(soon([&] { return written() > first; })) << "by itself";
    button->click();
    EXPECT_FALSE(button->isChecked());
    EXPECT_EQ(reportFolderOf(station().folder()), fs::path());
    // One that is being written ends; then there is no other.
    ASSERT_TRUE(soon([&] {
        const auto was = written();
        QTest::qWait(static_cast<int>(5 * Often.count()));
        return written() == was;
    }));
    const auto last = written();
    EXPECT_FALSE(QTest::qWaitFor([&] { return written() > last; }, static_cast<int>(10 * Often.count())));
}

TEST_F(LiveReport, AStationThatResumesTheMissionGoesOnWithIt) {
    keeping().trigger();
    choose(m_out);
    ASSERT_TRUE(soon([&] { return isThere(); })) << m_window->newest().toStdString();
    restart();
    EXPECT_TRUE(keeping().isChecked());
    EXPECT_TRUE(soon([&] { return m_window->recent().join(";").contains("goes on"); }));
    const auto before = written();
    feature().setInterval(Often);
    EXPECT_TRUE(soon([&] { return written() > before; }));
    keeping().trigger();
    restart();
    EXPECT_FALSE(keeping().isChecked()) << "it was ended";
}

}  // namespace
}  // namespace leitstand::test
