#include "core/mission/finds/behind.h"

#include <chrono>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

const Eigen::Vector3d Body(2.0, 0.0, 0.2), Wall(4.0, 0.1, 0.3), Camera(0.0, 0.0, 0.3);
constexpr double Nowhere = std::numeric_limits<double>::quiet_NaN();

Time at(double seconds) {
    return Time(std::chrono::milliseconds(1'000'000 + static_cast<int>(1000.0 * seconds)));
}

/// A book that sees warm things, half a second apart.
class Looking {
public:
    void see(const Eigen::Vector3d& place, const Eigen::Vector3d& from, int times = 8) {
        for (int i = 0; i < times; ++i) {
            PlacedCue cue;
            cue.cue.kind = "heat";
            cue.cue.robot = "kurt3d";
            cue.cue.confidence = 0.9;
            cue.cue.stamp = at(m_time);
            cue.inMap = place;
            cue.from = from;
            cue.covariance = 0.01 * Eigen::Matrix3d::Identity();
            book.add(cue);
            m_time += 0.5;
            for (const CandidateSample& one : book.due(at(m_time))) reported[one.id] = one;
        }
    }
    [[nodiscard]] std::vector<CandidateSample> standing() const {
        std::vector<CandidateSample> list;
        for (const auto& [id, one] : reported) {
            if (!one.dismissed) list.push_back(one);
        }
        return list;
    }
    CandidateBook book{"us"};
    std::map<std::uint32_t, CandidateSample> reported;

private:
    double m_time = 0.0;
};

TEST(SeenPast, IsTheShareOfTheWayToTheBody) {
    const CandidateSettings settings;
    const auto share = sharePassing(Camera, {4, 0, 0.3}, Body, settings);
    ASSERT_TRUE(share);
    EXPECT_NEAR(*share, 0.5, 1e-9);
    EXPECT_FALSE(sharePassing(Camera, {2.3, 0, 0.3}, Body, settings)) << "it ends at the body";
    EXPECT_FALSE(sharePassing(Camera, {4, 2, 0.3}, Body, settings)) << "it goes by";
    EXPECT_FALSE(sharePassing({3, 0, 0.3}, {5, 0, 0.3}, Body, settings)) << "the body is behind the camera";
    EXPECT_FALSE(sharePassing({Nowhere, 0, 0}, {4, 0, 0.3}, Body, settings));
    EXPECT_FALSE(sharePassing(Camera, Camera, Body, settings));
}

TEST(SeenPast, AWavingArmIsNotASecondPersonAtTheWall) {
    Looking one;
    one.see(Body, Camera);
    one.see(Wall, Camera, 30);
    ASSERT_EQ(one.standing().size(), 1u);
    EXPECT_LT((one.standing()[0].positionInMap - Body).head<2>().norm(), 0.1) << "nor does it move the first";
}

TEST(SeenPast, WhatWasToldBeforeThePersonIsTakenBackAndMayComeAgain) {
    Looking one;
    one.see(Wall, Camera);
    ASSERT_EQ(one.standing().size(), 1u);
    one.see(Body, Camera);
    ASSERT_EQ(one.standing().size(), 1u);
    EXPECT_LT((one.standing()[0].positionInMap - Body).head<2>().norm(), 0.1);
    // The next session knows that nobody has dismissed it.
    CandidateBook next("us");
    for (const auto& [id, sample] : one.reported) next.take(sample);
    PlacedCue cue;
    cue.cue.kind = "heat";
    cue.cue.confidence = 0.9;
    cue.inMap = Wall;
    cue.covariance = 0.01 * Eigen::Matrix3d::Identity();
    std::vector<CandidateSample> reported;
    for (int i = 0; i < 10; ++i) {
        cue.cue.stamp = at(100.0 + i);
        next.add(cue);
        for (const CandidateSample& sample : next.due(at(100.5 + i))) reported.push_back(sample);
    }
    EXPECT_TRUE(std::any_of(reported.begin(), reported.end(), [](const CandidateSample& sample) {
        return !sample.dismissed && (sample.positionInMap - Wall).norm() < 0.1;
    }));
}

TEST(SeenPast, ASecondPersonBehindIsFoundFromTheSide) {
    Looking one;
    one.see(Body, Camera);
    one.see(Wall, Camera);
    one.see(Wall, {4.0, 2.5, 0.3});
    EXPECT_EQ(one.standing().size(), 2u);
    one.see(Wall, Camera, 4);
    EXPECT_EQ(one.standing().size(), 2u) << "and stays, seen past the first again";
}

TEST(SeenPast, NothingIsHeldBackByWhatTheOperatorDismissed) {
    Looking one;
    one.see(Body, Camera);
    CandidateSample dismissed = one.standing()[0];
    dismissed.dismissed = true;
    dismissed.stamp += std::chrono::hours(1);
    one.book.take(dismissed);
    one.see(Wall, Camera);
    EXPECT_TRUE(std::any_of(one.reported.begin(), one.reported.end(),
                            [](const std::pair<const std::uint32_t, CandidateSample>& sample) {
                                return (sample.second.positionInMap - Wall).head<2>().norm() < 0.1;
                            }));
}

}  // namespace
}  // namespace leitstand::test
