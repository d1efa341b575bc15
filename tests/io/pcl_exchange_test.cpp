#include <cmath>

#include <gtest/gtest.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_types.h>

#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "tests/io/file_checks.h"
#include "tests/io/sample_scans.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::expectSameScan;
using test::sampleScan;
using test::TemporaryFolder;

pcl::PointCloud<pcl::PointXYZI> asPclCloud(const Scan& scan) {
    pcl::PointCloud<pcl::PointXYZI> cloud;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        pcl::PointXYZI point(scan.intensities[i]);
        point.getVector3fMap() = scan.points[i];
        cloud.push_back(point);
    }
    cloud.width = static_cast<std::uint32_t>(scan.columns);
    cloud.height = static_cast<std::uint32_t>(scan.rows);
    cloud.is_dense = false;
    return cloud;
}

template <class Cloud>
void expectSamePoints(const Cloud& cloud, const Scan& scan) {
    ASSERT_EQ(cloud.size(), scan.points.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Eigen::Vector3f point = cloud[i].getVector3fMap();
        if (!test::samePoint(point, scan.points[i])) ++different;
    }
    EXPECT_EQ(different, 0U);
}

/// PCL writes no NaN as PLY and reads none from text.
void withoutGaps(Scan& scan) {
    for (Eigen::Vector3f& point : scan.points) {
        if (!point.allFinite()) point.setZero();
    }
}

class PclExchange : public ::testing::Test {
protected:
    PclExchange() { m_scan.labels.clear(); }

    const TemporaryFolder m_folder;
    Scan m_scan = sampleScan(Sweep::Tilting, 40, 90);
};

TEST_F(PclExchange, ReadsWhatPclWritesAsPcd) {
    const auto cloud = asPclCloud(m_scan);
    const std::string file = (m_folder / "room.pcd").string();
    const auto check = [&] {
        const auto read = readPcd(file);
        ASSERT_TRUE(read.ok()) << errorOf(read);
        expectSameScan(read->scan, m_scan);
    };
    pcl::PCDWriter writer;
    ASSERT_EQ(writer.writeASCII(file, cloud, 9), 0);
    check();
    ASSERT_EQ(writer.writeBinary(file, cloud), 0);
    check();
    ASSERT_EQ(writer.writeBinaryCompressed(file, cloud), 0);
    check();
}

TEST_F(PclExchange, ReadsWhatPclWritesAsPly) {
    withoutGaps(m_scan);
    const auto cloud = asPclCloud(m_scan);
    const std::string file = (m_folder / "room.ply").string();
    for (const bool binary : {false, true}) {
        pcl::PCLPointCloud2 blob;
        pcl::toPCLPointCloud2(cloud, blob);
        pcl::PLYWriter writer;
        ASSERT_EQ(
            writer.write(file, blob, Eigen::Vector4f::Zero(), Eigen::Quaternionf::Identity(), binary, false),
            0);
        const auto read = readPly(file);
        ASSERT_TRUE(read.ok()) << errorOf(read);
        ASSERT_EQ(read->scan.points.size(), m_scan.points.size());
        EXPECT_TRUE(read->scan.points.back().isApprox(m_scan.points.back(), 1e-4F));
        EXPECT_EQ(read->scan.intensities.size(), m_scan.intensities.size());
    }
}

TEST_F(PclExchange, WritesPcdThatPclReads) {
    for (const PcdEncoding encoding :
         {PcdEncoding::Ascii, PcdEncoding::Binary, PcdEncoding::BinaryCompressed}) {
        ASSERT_TRUE(writePcd(m_folder / "room.pcd", m_scan, encoding).ok());
        pcl::PointCloud<pcl::PointXYZI> cloud;
        ASSERT_EQ(pcl::io::loadPCDFile((m_folder / "room.pcd").string(), cloud), 0);
        EXPECT_EQ(cloud.width, 90U);
        EXPECT_EQ(cloud.height, 40U);
        expectSamePoints(cloud, m_scan);
        EXPECT_EQ(cloud.back().intensity, m_scan.intensities.back());
    }
}

TEST_F(PclExchange, WritesLabelsThatPclReads) {
    m_scan = sampleScan(Sweep::Tilting, 40, 90);
    ASSERT_TRUE(writePcd(m_folder / "room.pcd", m_scan).ok());
    pcl::PointCloud<pcl::PointXYZL> cloud;
    ASSERT_EQ(pcl::io::loadPCDFile((m_folder / "room.pcd").string(), cloud), 0);
    expectSamePoints(cloud, m_scan);
    for (std::size_t i = 0; i < cloud.size(); i += 7) {
        EXPECT_EQ(cloud[i].label, static_cast<std::uint32_t>(m_scan.labels[i]));
    }
}

TEST_F(PclExchange, WritesPlyThatPclReads) {
    for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::Binary}) {
        for (Scan scan : {m_scan, test::shuffledScan(m_scan)}) {
            withoutGaps(scan);
            ASSERT_TRUE(writePly(m_folder / "room.ply", scan, encoding).ok());
            pcl::PointCloud<pcl::PointXYZ> cloud;
            ASSERT_EQ(pcl::io::loadPLYFile((m_folder / "room.ply").string(), cloud), 0);
            expectSamePoints(cloud, scan);
        }
    }
}

}  // namespace
}  // namespace leitstand
