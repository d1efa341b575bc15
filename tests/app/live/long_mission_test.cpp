#include <cstdlib>
#include <filesystem>

#include <QElapsedTimer>

#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/handin/writing/report_writer.h"
#include "app/services/station/station_mapping.h"
#include "app/window/layouts/layout_feature.h"
#include "core/mission/state/mission_state.h"
#include "tests/app/live/live_page.h"

namespace leitstand::test {
namespace {

/// A mission that both robots drive by themselves while an operator files what the station finds. Also makes
/// resources/samples anew: with LEITSTAND_SAMPLE=FOLDER the mission is copied there.
class LongMission : public LivePage {
protected:
    static constexpr int Drive = 80'000;       ///< [ms]
    static constexpr int MostDrive = 240'000;  ///< [ms] where no victim lies beside the way so far

    [[nodiscard]] std::size_t confirmed() const { return confirmedVictims(station()); }

    /// Where Kurt3D has stood before something for @p Looked, it is told to explore on, as an operator does
    /// who has filed what is there, or seen that nothing is.
    void sendOn(QElapsedTimer& stands) {
        const auto mode = station().mission()->robots.at("kurt3d")->mode;
        const bool waits =
            mode && mode->sample.mode == "victim_approach" && mode->sample.reason.rfind("stands", 0) == 0;
        if (!waits) return stands.invalidate();
        if (!stands.isValid()) return stands.start();
        if (stands.elapsed() < Looked) return;
        stands.invalidate();
        EXPECT_TRUE(station().setMode("kurt3d", "explore"));
    }
    static constexpr int Looked = 12'000;  ///< [ms]
};

TEST_F(LongMission, DrivenByTheRobotsFiledByKeysResumedAndReported) {
    m_window->layouts().use("explore");
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    MissionInfoSample info;
    info.competition = "RoboCup2026";
    info.team = "Leitstand";
    info.country = "Germany";
    info.mission = "Sample";
    info.area = "yellow";
    info.profile = "2005";
    ASSERT_TRUE(station().describe(info));
    for (const char* name : {"kurt3d", "crawler"}) {
        const auto mode = [&] { return station().mission()->robots.at(name)->mode; };
        station().requestGrant(name);
        ASSERT_TRUE(soon([&] { return robot(name).grant.mine; })) << name;
        ASSERT_TRUE(station().setMode(name, "explore")) << name;
        ASSERT_TRUE(soon([&] { return mode() && mode()->sample.autonomous; })) << name;
    }
    QElapsedTimer clock, stands;
    clock.start();
    bool resumed = false;
    while (clock.elapsed() < (confirmed() > 0 ? Drive : MostDrive)) {
        QTest::qWait(2'000);
        fileNextFind(*m_window);
        sendOn(stands);
        if (resumed || clock.elapsed() < Drive / 2) continue;
        const std::size_t before = confirmed();
        restart();
        m_window->layouts().use("explore");
        resumed = true;
        ASSERT_TRUE(soon([&] { return confirmed() >= before; })) << "nothing is lost";
    }
    lookAt("long_mission");
    const std::size_t found = confirmed();
    EXPECT_GE(found, 1U) << "a warm body beside its way was found and filed";
    EXPECT_GE(station().mapping().scans()->scans.size(), 3U);
    const std::filesystem::path mission = station().folder(), out = m_folder.path().toStdString() + "/report";
    m_window.reset();
    m_bridge.reset();  // the mission is self-contained
    const auto report = writeReport(mission, out, {});
    ASSERT_TRUE(report) << report.error().text;
    EXPECT_TRUE(report->whole());
    EXPECT_EQ(report->victims, found);
    std::printf("  %zu victims confirmed, %zu scans, %.1f m2 explored, report in %.1f s\n", found,
                report->scans, report->explored, report->seconds);
    if (const char* sample = std::getenv("LEITSTAND_SAMPLE"))
        std::filesystem::copy(mission, sample, std::filesystem::copy_options::recursive);
}

}  // namespace
}  // namespace leitstand::test
