#include "core/io/clouds/cloud_writer.h"

#include <sys/resource.h>

#include <csignal>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/scan_source.h"
#include "core/io/clouds/uos.h"
#include "tests/io/file_checks.h"
#include "tests/io/sample_scans.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using ::testing::HasSubstr;

std::size_t echoesOf(const Scan& scan) {
    std::size_t echoes = 0;
    for (const Eigen::Vector3f& point : scan.points) echoes += point.allFinite() ? 1 : 0;
    return echoes;
}

std::size_t filesIn(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

class MapCloud : public ::testing::Test {
protected:
    MapCloud() {
        const auto scan = std::make_shared<Scan>(test::sampleScan(Sweep::Tilting, 20, 60));
        m_scans = {{scan, Pose::Identity()}, {scan, poseFrom({1, 2, 3}, 0.1, 0.2, 0.3)}};
    }

    const TemporaryFolder m_folder;
    std::vector<PlacedScan> m_scans;
};

TEST_F(MapCloud, IsOneCloudOfAllEchoesInMapCoordinates) {
    const Scan& scan = *m_scans[0].scan;
    const std::size_t echoes = echoesOf(scan);
    for (const CloudFormat& format : cloudFormats()) {
        if (format.write == nullptr) continue;
        const std::string name = "map" + std::string(format.ending);
        const auto wrote = writeMapCloud(m_folder / name, m_scans);
        ASSERT_TRUE(wrote.ok()) << errorOf(wrote);
        const auto read = readScan(m_folder / name);
        ASSERT_TRUE(read.ok()) << errorOf(read);
        ASSERT_EQ(read->scan.points.size(), 2 * echoes) << name;
        EXPECT_EQ(read->scan.labels.size(), 2 * echoes);
        EXPECT_EQ(read->scan.intensities.size(), 2 * echoes);
        EXPECT_FALSE(read->scan.organised());
        const Eigen::Vector3f moved =
            (m_scans[1].poseInMap * read->scan.points[5].cast<double>()).cast<float>();
        EXPECT_TRUE(read->scan.points[echoes + 5].isApprox(moved, 1e-6F));
        EXPECT_EQ(read->scan.labels[echoes + 5], read->scan.labels[5]);
    }
}

TEST_F(MapCloud, HasIntensitiesOnlyWhenAllScansHaveThem) {
    auto dark = std::make_shared<Scan>(*m_scans[0].scan);
    dark->intensities.clear();
    dark->labels.clear();
    m_scans[1].scan = dark;
    ASSERT_TRUE(writeMapCloud(m_folder / "map.pcd", m_scans).ok());
    const auto read = readScan(m_folder / "map.pcd");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_TRUE(read->scan.intensities.empty());
    EXPECT_EQ(read->scan.labels.back(), Label::Unlabelled);
}

TEST_F(MapCloud, LeavesOutWhatIsBeyondTheRange) {
    ASSERT_TRUE(writeMapCloud(m_folder / "map.pcd", {m_scans[0]}, {1.5, 3.0}).ok());
    const auto read = readScan(m_folder / "map.pcd");
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_LT(read->scan.points.size(), echoesOf(*m_scans[0].scan));
    for (const Eigen::Vector3f& point : read->scan.points) {
        EXPECT_GE(point.norm(), 1.499F);
        EXPECT_LE(point.norm(), 3.001F);
    }
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "none.pcd", m_scans, {1e6, 2e6})),
                HasSubstr("no point is in range"));
}

TEST_F(MapCloud, AFolderHoldsUosScansWithTheirPosesInTheMap) {
    const auto out = m_folder / "deep/map/";
    for (int round = 0; round < 2; ++round) {
        const auto wrote = writeMapCloud(out, m_scans);
        ASSERT_TRUE(wrote.ok()) << errorOf(wrote) << " in round " << round;
    }
    const auto files = listScans({out});
    ASSERT_TRUE(files.ok()) << errorOf(files);
    ASSERT_EQ(files->size(), 2U);
    const auto read = readScan(files->back());
    ASSERT_TRUE(read.ok()) << errorOf(read);
    EXPECT_EQ(read->scan.rows, 20);
    EXPECT_EQ(read->scan.columns, 60);
    EXPECT_TRUE(read->scan.sensorInOdom.isApprox(m_scans[1].poseInMap, 1e-9));
    const auto frames = readUosFrames(out / "scan001.frames");
    ASSERT_TRUE(frames.ok()) << errorOf(frames);
    EXPECT_TRUE(frames->back().pose.isApprox(m_scans[1].poseInMap, 1e-9));
}

TEST_F(MapCloud, NeverWritesOverARobotsOwnScans) {
    ASSERT_TRUE(writeUosScan(m_folder / "scan000.3d", *m_scans[0].scan).ok());
    const std::string before = test::readText(m_folder / "scan000.3d");
    EXPECT_THAT(errorOf(writeMapCloud(m_folder.path(), m_scans)), HasSubstr("scan000.3d: is in the way"));
    EXPECT_EQ(test::readText(m_folder / "scan000.3d"), before);
}

TEST_F(MapCloud, DoesNotMixWithAFormerLargerMap) {
    ASSERT_TRUE(writeMapCloud(m_folder / "map/", m_scans).ok());
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "map/", {m_scans[0]})),
                HasSubstr("scan001.3d: is in the way"));
}

TEST_F(MapCloud, SaysWhyItCannotBeWritten) {
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "map.pcd", {})), HasSubstr("the map is empty"));
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "map.las", m_scans)),
                HasSubstr("expected an ending .pcd, .ply or .xyz"));
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "no/map.pcd", m_scans)),
                HasSubstr("map.pcd: cannot be written: No such file or directory"));
    test::writeText(m_folder / "file", "");
    EXPECT_THAT(errorOf(writeMapCloud(m_folder / "file/map/", m_scans)), HasSubstr("cannot be created"));
}

TEST_F(MapCloud, AFullDiskLeavesTheFormerFileAndNothingElse) {
    for (const std::string name : {"map.pcd", "map.ply", "map.xyz"}) {
        const auto file = m_folder / name;
        test::writeText(file, "the former map");
        // A limit on the size of files stands for a full disk.
        rlimit former{};
        ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &former), 0);
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{4096, former.rlim_max};
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
        const auto wrote = writeMapCloud(file, m_scans);
        ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &former), 0);
        std::signal(SIGXFSZ, handler);
        EXPECT_THAT(errorOf(wrote), HasSubstr(name + ": cannot be written: File too large"));
        EXPECT_EQ(test::readText(file), "the former map");
    }
    EXPECT_EQ(filesIn(m_folder.path()), 3U);
}

}  // namespace
}  // namespace leitstand
