#include "app/services/mapping/scanner_advice.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/mapping/station_scanners.h"
#include "core/io/robot/robot_file.h"
#include "tests/app/services/mapped_station.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
class ScannerAdviceTest : public StationMappingTest {
protected:
    /// Drives in a circle with a scanner that measures 4 cm too far until the map asks about it; the key scan
    /// that made it.
    std::uint64_t driveUntilAsked() {
        m_tooFar = 0.04;
        m_circles = true;
        begin();
        std::uint64_t newest = 0;
        while (newest < 30 && !m_mapping->scanners().question()) {
            scan();
            if (!scans(++newest)) break;
        }
        return newest;
    }
};

/// Of the points of the key scan @p id below the scanner, which is 0.9 m above the floor [m].
double heightAboveFloor(const StationMapping& mapping, std::uint64_t id) {
    double sum = 0.0;
    int count = 0;
    const LiveMapPtr map = mapping.scans();
    for (const Eigen::Vector3f& point : map->scans.at(id - 1).scan->points) {
        if (point.z() > -0.8F || point.head<2>().norm() > 0.6F) continue;
        sum -= static_cast<double>(point.z());
        ++count;
    }
    return sum / count;
}

TEST_F(ScannerAdviceTest, AScannerThatMeasuresTooFarIsAskedAboutAndCorrectedForGood) {
    m_robotFile = m_folder / "kurt3d.yaml";
    const std::string head = "letter: K\nname: kurt3d\nsensors:\n  laser:\n";
    const std::string tail =
        "    position: [0, 0, 0.9]  # measured\nstreams: [{role: points, sensor: laser}]\n";
    std::ofstream(m_robotFile) << head << tail;
    const std::uint64_t asked = driveUntilAsked();
    const auto question = m_mapping->scanners().question();
    ASSERT_TRUE(question.has_value()) << words();
    EXPECT_THAT(words(), HasSubstr("what its 3D scanner measures does not fit together"));
    EXPECT_EQ(question->robot, "kurt3d");
    EXPECT_NEAR(question->more.range, -0.04, 0.008);
    EXPECT_NEAR(heightAboveFloor(*m_mapping, asked), 0.936, 0.005) << "nothing changes before the answer";
    ASSERT_TRUE(m_mapping->scanners().answer(*question, true).ok());
    EXPECT_THAT(words(),
                HasSubstr("its 3D scanner is corrected from its next scan on, and from now on by its "
                          "file " +
                          m_robotFile.string()));
    EXPECT_EQ(m_mapping->scanners().question(), std::nullopt);
    EXPECT_FALSE(m_mapping->scanners().answer(*question, true).ok()) << "nothing is asked any more";
    for (std::uint64_t more = asked + 1; more <= asked + 16; ++more) {
        scan();
        ASSERT_TRUE(scans(more)) << words();
        EXPECT_NEAR(heightAboveFloor(*m_mapping, more), 0.9, 0.01) << more;
        EXPECT_EQ(trust(more), ScanTrust::Certain) << more;
    }
    EXPECT_EQ(m_mapping->scanners().question(), std::nullopt) << "what is right is not asked about";
    const auto file = readRobot(m_robotFile);
    ASSERT_TRUE(file.ok()) << file.error().text;
    EXPECT_NEAR(file->sensors.at("laser").correction.range, question->more.range, 1e-4);
    const auto kept = readRobot(m_folder / "mission" / "robots" / "kurt3d.yaml");
    ASSERT_TRUE(kept.ok()) << kept.error().text;
    EXPECT_NEAR(kept->sensors.at("laser").correction.range, question->more.range, 1e-4)
        << "who registers the mission's scans again needs it";
}

TEST_F(ScannerAdviceTest, AFindingThatWasOnItsWayDuringTheAnswerDoesNotAskAgain) {
    ScannerAdvice advice({kurt()}, {});
    const ScannerFinding found{{}, ScannerCorrection{.range = -0.04}};
    EXPECT_TRUE(advice.follow("kurt3d", found));
    const auto question = advice.question();
    ASSERT_TRUE(question);
    const ScannerCorrection total = advice.use(*question).total;
    EXPECT_FALSE(advice.follow("kurt3d", found));
    EXPECT_FALSE(advice.question()) << "it would be corrected twice";
    EXPECT_TRUE(advice.follow("kurt3d", {total, ScannerCorrection{.range = 0.02}}));
    EXPECT_TRUE(advice.question()) << "what is measured with the correction does ask";
}

TEST_F(ScannerAdviceTest, AScannerThatIsLeftAsItIsIsNotAskedAboutAgain) {
    const std::uint64_t asked = driveUntilAsked();
    const auto question = m_mapping->scanners().question();
    ASSERT_TRUE(question.has_value()) << words();
    ScannerQuestion other = *question;
    other.more = {0.0, degrees(1), 0.0};
    EXPECT_FALSE(m_mapping->scanners().answer(other, true).ok()) << "its lean is not asked about";
    m_granted = false;
    EXPECT_FALSE(m_mapping->scanners().answer(*question, false).ok()) << "the map is another station's";
    m_granted = true;
    ASSERT_TRUE(m_mapping->scanners().answer(*question, false).ok());
    for (int i = 1; i <= 3; ++i) {
        scan();
        ASSERT_TRUE(scans(asked + static_cast<std::uint64_t>(i))) << words();
    }
    EXPECT_EQ(m_mapping->scanners().question(), std::nullopt);
    EXPECT_NEAR(heightAboveFloor(*m_mapping, asked + 3), 0.936, 0.005);
}

}  // namespace
}  // namespace leitstand::test
