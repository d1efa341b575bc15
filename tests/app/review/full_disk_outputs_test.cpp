// A disk that is full: what is written for others is whole, or not there.
#include <cerrno>
#include <cstring>
#include <set>

#include <sys/mount.h>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/mission_export.h"
#include "app/services/handin/writing/report_writer.h"
#include "app/services/thinning/mission_thinning.h"
#include "tests/app/review/written_mission.h"
#include "tests/support/attack.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// A disk of 1 MB with little space, and a mission elsewhere.
class FullOutputs : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directory(m_disk);
        if (::mount("tmpfs", m_disk.c_str(), "tmpfs", 0, "size=1m") != 0)
            GTEST_SKIP() << "SKIPPED: a small disk cannot be mounted (" << std::strerror(errno)
                         << "): this test needs root";
        m_mounted = true;
        writeText(m_disk / "ballast", std::string(500'000, 'b'));
        WrittenMission mission(m_folder / "whole");
        writeMinute(mission);
        mission.close();
    }
    void TearDown() override {
        if (m_mounted) ::umount2(m_disk.c_str(), MNT_DETACH);
    }
    [[nodiscard]] std::set<std::string> left() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(m_disk))
            names.insert(fs::relative(entry.path(), m_disk).string());
        return names;
    }

    const TemporaryFolder m_folder;
    const fs::path m_disk = m_folder / "disk";
    bool m_mounted = false;
};

TEST_F(FullOutputs, ThinLeavesNothingBehind) {
    const std::set<std::string> before = left();
    for (const char* out : {"thin", "new/folders/thin"}) {
        ThinningSettings settings;
        settings.pictures = settings.clouds = settings.motion = 1'000.0;  // more than there is space for
        const auto done = thinMission(m_folder / "whole", m_disk / out, settings);
        ASSERT_FALSE(done.ok()) << done->kept;
        EXPECT_THAT(done.error().text, testing::HasSubstr("full"));
        EXPECT_EQ(left(), before) << out;
    }
    tellAttack("log", "the disk gets full while a mission is thinned", 2,
               "it is told, and nothing is left behind");
}

TEST_F(FullOutputs, ACancelledThinLeavesNothingBehind) {
    std::stop_source stop;
    const auto stopSoon = [&](double done) {
        if (done > 0.5) stop.request_stop();
    };
    const auto done = thinMission(m_folder / "whole", m_folder / "thin", {}, {stopSoon, stop.get_token()});
    ASSERT_FALSE(done.ok());
    EXPECT_FALSE(fs::exists(m_folder / "thin"));
}

TEST_F(FullOutputs, ExportsAreWholeOrNotThere) {
    writeText(m_disk / "more", std::string(480'000, 'b'));
    const std::set<std::string> before = left();
    for (const char* out : {"map.pcd", "map.ply", "map.bt", "map.tif", "way.tum", "scans/", "new/scans/"}) {
        const auto done = exportMission(m_folder / "whole", m_disk / out, {});
        if (done.ok()) {  // small enough
            fs::remove_all(m_disk / out);
            continue;
        }
        EXPECT_EQ(left(), before) << out << ": " << done.error().text;
    }
}

TEST_F(FullOutputs, AReportHasNoHalfFiles) {
    writeText(m_disk / "more", std::string(470'000, 'b'));
    const auto done = writeReport(m_folder / "whole", m_disk / "report", {});
    EXPECT_THAT(done ? "cannot be written" : done.error().text, testing::HasSubstr("cannot be written"));
    for (const std::string& name : left())
        EXPECT_FALSE(fs::path(name).filename().string().starts_with("."))
            << name << " is a file that was begun";
}

}  // namespace
}  // namespace leitstand::test
