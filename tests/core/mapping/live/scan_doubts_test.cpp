#include "core/mapping/live/scan_doubts.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/scan_pose.h"
#include "core/mapping/live/scan_work.h"
#include "tests/support/rooms.h"

namespace leitstand::test {
namespace {

const Pose Guess = poseFrom({0.05, -0.03, 0.01}, 0, 0, degrees(1));  ///< the truth is the identity

std::uint8_t bits(ScanDoubt doubt) {
    return static_cast<std::uint8_t>(doubt);
}

double above(double value) {
    return std::nextafter(value, std::numeric_limits<double>::infinity());
}

double below(double value) {
    return std::nextafter(value, -std::numeric_limits<double>::infinity());
}

/// Allows everything.
FitSettings lenient() {
    FitSettings fit;
    fit.leastOverlap = fit.leastOverlapUnguided = fit.leastCertainty = 0.0;
    fit.mostResidual = fit.jump = fit.turn = 10.0;
    fit.leastPoints = 0;
    return fit;
}

/// A room as the map has it, and scans that are made of its points.
class ScanDoubts : public testing::Test {
protected:
    ScanDoubts() {
        m_local.scans = {1};
        m_local.cloud = roomCloud(40'000, 1);
        m_local.search = makeSearch(m_local.cloud, SearchMethod::KdTree);
    }
    /// @p near points of the room, every other one before its surface by @p off [m], the others behind it,
    /// and @p far points where the map has none.
    [[nodiscard]] PointCloud scanOf(int near, int far, float off) const {
        PointCloud cloud;
        const std::size_t step = m_local.cloud.size() / static_cast<std::size_t>(near);
        for (int i = 0; i < near; ++i) {
            const std::size_t at = step * static_cast<std::size_t>(i);
            const Eigen::Vector3f& normal = m_local.cloud.normals[at];
            cloud.points.push_back(m_local.cloud.points[at] + (i % 2 == 0 ? off : -off) * normal);
            cloud.normals.push_back(normal);
        }
        for (int i = 0; i < far; ++i) {
            cloud.points.emplace_back(0.05F * static_cast<float>(i % 30), 0.05F * static_cast<float>(i / 30),
                                      20.0F);
            cloud.normals.push_back(Eigen::Vector3f::UnitZ());
        }
        return cloud;
    }
    [[nodiscard]] Match matched(const PointCloud& cloud, const FitSettings& fit, bool measured = true,
                                int iterations = MatchSettings{}.maxIterations) const {
        MatchSettings settings;
        settings.maxIterations = iterations;
        return match(cloud, m_local, Guess, {.measured = measured, .trusted = measured}, std::nullopt,
                     settings, fit, settings.near);
    }

    LocalMap m_local;
};

TEST_F(ScanDoubts, EachIsRaisedJustBeyondItsLimit) {
    const PointCloud cloud = scanOf(1'600, 400, 0.02F);
    const Match found = matched(cloud, lenient());
    ASSERT_EQ(found.doubts, 0) << inWords(found.doubts);
    ASSERT_GT(found.icp.rms, 0.005);
    const IcpResult& icp = found.icp;
    const double jump = distanceBetween(Guess, icp.pose), turn = angleBetween(Guess, icp.pose);
    struct Row {
        double FitSettings::*limit;
        double holds, breaks;
        ScanDoubt doubt;
    };
    const std::vector<Row> table = {
        {&FitSettings::leastOverlap, icp.overlap, above(icp.overlap), ScanDoubt::Overlap},
        {&FitSettings::mostResidual, icp.rms, below(icp.rms), ScanDoubt::Residual},
        {&FitSettings::leastCertainty, icp.certainty, above(icp.certainty), ScanDoubt::Certainty},
        {&FitSettings::jump, jump, below(jump), ScanDoubt::Jump},
        {&FitSettings::turn, turn, below(turn), ScanDoubt::Jump}};
    for (const Row& row : table) {
        FitSettings fit = lenient();
        fit.*row.limit = row.holds;
        EXPECT_EQ(matched(cloud, fit).doubts, 0) << inWords(bits(row.doubt));
        fit.*row.limit = row.breaks;
        const Match doubted = matched(cloud, fit);
        EXPECT_EQ(doubted.doubts, bits(row.doubt)) << inWords(doubted.doubts);
        EXPECT_TRUE(doubted.scanInMap.isApprox(Guess, 0.0)) << "where odometry says";
    }
}

TEST_F(ScanDoubts, ARegistrationThatNeedsOneIterationMoreThanItHasCameToNoEnd) {
    const PointCloud cloud = scanOf(1'600, 400, 0.02F);
    const Match found = matched(cloud, lenient());
    ASSERT_EQ(found.doubts, 0) << inWords(found.doubts);
    ASSERT_GT(found.icp.iterations, 1);
    EXPECT_EQ(matched(cloud, lenient(), true, found.icp.iterations).doubts, 0);
    EXPECT_EQ(matched(cloud, lenient(), true, found.icp.iterations - 1).doubts, bits(ScanDoubt::Diverged));
}

TEST_F(ScanDoubts, FortyOfAHundredPointsMeetTheMapAndSixtyWithoutOdometry) {
    const auto doubts = [&](int near, bool measured) {
        return matched(scanOf(near, 1'000 - near, 0.02F), FitSettings{}, measured).doubts;
    };
    EXPECT_EQ(doubts(400, true), 0);
    EXPECT_EQ(doubts(399, true), bits(ScanDoubt::Overlap));
    EXPECT_EQ(doubts(600, false), 0);
    EXPECT_EQ(doubts(599, false), bits(ScanDoubt::Overlap) | bits(ScanDoubt::Odometry));
}

TEST_F(ScanDoubts, PairsThatAreFarApartAreABadFit) {
    const auto doubts = [&](float off) { return matched(scanOf(1'000, 0, off), FitSettings{}).doubts; };
    EXPECT_FALSE(has(doubts(0.04F), ScanDoubt::Residual));
    EXPECT_TRUE(has(doubts(0.1F), ScanDoubt::Residual));
}

TEST_F(ScanDoubts, AScanOfTooFewPointsOrWithoutAMapIsNotMatched) {
    const PointCloud cloud = scanOf(1'000, 0, 0.02F);
    FitSettings fit = lenient();
    fit.leastPoints = 1'000;
    EXPECT_EQ(matched(cloud, fit).doubts, 0);
    fit.leastPoints = 1'001;
    EXPECT_EQ(matched(cloud, fit).doubts, bits(ScanDoubt::Points));
    m_local.search.reset();
    EXPECT_EQ(matched(cloud, lenient()).doubts, bits(ScanDoubt::Overlap));
}

}  // namespace
}  // namespace leitstand::test
