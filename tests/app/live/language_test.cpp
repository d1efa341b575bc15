#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include <QAbstractItemView>
#include <QAction>
#include <QFileDialog>

#include <gtest/gtest.h>

#include "app/language/language.h"
#include "app/services/station/station_clock.h"
#include "app/window/commands/command_table.h"
#include "app/window/panes/score/report_feature.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/live/live_page.h"
#include "tests/support/places.h"
#include "widgets/drive/gas_cell.h"
#include "widgets/messages/messages_panel.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// The language chosen while robots are there.
class LiveLanguage : public LivePage {
protected:
    ~LiveLanguage() override { useLanguage(QStringLiteral("en")); }
    /// As the application does when the window asks for it.
    void makeAnew(const QString& language) {
        m_window.reset();
        ASSERT_TRUE(useLanguage(language));
        m_window =
            std::make_unique<LiveWindow>(*m_bridge, MapViewSettings{},
                                         LayoutBook(fs::path(m_folder.path().toStdString()) / "layouts",
                                                    sourceFolder() + "/resources/layouts"));
        m_window->resize(1280, 800);
        m_window->show();
        m_window->activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(m_window.get()));
    }
    [[nodiscard]] QAction& command(const char* id) const { return *m_window->commands().find(id); }
    /// How much of its cell the curve of CO2 takes in the strip, of 1.
    [[nodiscard]] double gasCurve() const {
        constexpr double Margins = 22.0;  // left and right of it [px]
        const QImage cell = m_window->findChild<GasCell*>()->grab().toImage();
        int least = cell.width(), most = 0;
        for (int y = 66; y < cell.height() - 44; ++y) {
            for (int x = 0; x < cell.width(); ++x) {
                if (qGray(cell.pixel(x, y)) < 150) continue;
                least = std::min(least, x);
                most = std::max(most, x);
            }
        }
        return std::max(0, most - least) / (cell.width() - Margins);
    }
    /// What the pane of messages lists.
    [[nodiscard]] QStringList messages() const {
        const QAbstractItemModel* const list =
            m_window->findChild<MessagesPanel*>("messagesPane")->findChild<QAbstractItemView*>()->model();
        QStringList all;
        for (int row = 0; row < list->rowCount(); ++row) all += list->index(row, 0).data().toString();
        return all;
    }
    [[nodiscard]] fs::file_time_type reported() const {
        std::error_code none;
        return fs::last_write_time(m_out / "SHA256SUMS", none);
    }

    const fs::path m_out = fs::path(m_folder.path().toStdString()) / "hand-in";
};

TEST_F(LiveLanguage, TheWindowIsMadeAnewWhileStationGrantsAndReportGoOn) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    m_window->setDriving(true);
    ASSERT_TRUE(soon([&] { return robot().grant.mine; }));
    command("mission.report").trigger();
    auto* dialog = m_window->findChild<QFileDialog*>("reportFolder");
    ASSERT_NE(dialog, nullptr);
    emit dialog->fileSelected(QString::fromStdString(m_out.string()));
    dialog->close();
    ASSERT_TRUE(soon([&] { return fs::exists(m_out / "SHA256SUMS"); })) << m_window->newest().toStdString();
    EXPECT_EQ(command("mission.report").text().toStdString(), "&Report into a folder…");
    const Station* const before = &station();
    const std::size_t scans = station().mission()->keyScans->size();
    const auto elapsed = station().clock().now().elapsed;
    EXPECT_TRUE(soon([&] { return gasCurve() > 0.07; })) << "8 s of two minutes";
    const double measured = gasCurve();
    const QStringList notified = messages();
    EXPECT_FALSE(notified.isEmpty());
    QString wanted;
    QObject::connect(m_window.get(), &LiveWindow::languageWanted, m_window.get(),
                     [&](const QString& code) { wanted = code; });
    m_window->commands().trigger("language.de");
    ASSERT_EQ(wanted.toStdString(), "de");
    ASSERT_NO_FATAL_FAILURE(makeAnew(wanted));

    EXPECT_EQ(command("mission.report").text().toStdString(), "&Bericht in einen Ordner…");
    EXPECT_GE(gasCurve(), measured - 0.01) << "what was measured before is known, all of it";
    const QStringList still = messages();  // with severity and time as the language has them
    for (const QString& one : notified) {
        const QString text = one.section(QStringLiteral("  "), 2);
        EXPECT_TRUE(!text.isEmpty() && still.filter(text).size() == 1) << one.toStdString();
    }
    EXPECT_TRUE(command("language.de").isChecked());
    EXPECT_FALSE(command("language.en").isChecked());
    EXPECT_EQ(&station(), before);
    EXPECT_TRUE(robot().grant.mine) << "it was not given back meanwhile";
    EXPECT_NE(robot().link.state, LinkState::Lost);
    EXPECT_TRUE(soon([&] {
        return robot().link.state == LinkState::Connected &&
               robot("crawler").link.state == LinkState::Connected;
    }));
    EXPECT_GE(station().mission()->keyScans->size(), scans);
    EXPECT_GE(station().clock().now().elapsed, elapsed);
    EXPECT_FALSE(m_window->driving()) << "motion does not resume by itself";
    EXPECT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    m_window->setDriving(true);
    EXPECT_TRUE(soon([&] { return m_window->driving() && robot().grant.mine; }));
    EXPECT_TRUE(command("mission.report").isChecked());
    const auto last = reported();
    m_window->findChild<ReportFeature*>()->setInterval(std::chrono::milliseconds(300));
    EXPECT_TRUE(soon([&] { return reported() > last; })) << "the report is written again";
}

}  // namespace
}  // namespace leitstand::test
