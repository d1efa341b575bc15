// Heights above the floor where floors lie above each other, and what the two maps show of what stands there.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/handin/report_scene.h"

namespace leitstand::test {
namespace {

using State = OccupancyGrid::State;

constexpr float Deck = 0.9F;  ///< height of the deck [m]

/// A floor of 8 m x 3 m, over part of which a ramp leads up to a deck, from x = 2 m to 5 m and on to 8 m; the
/// floor below is seen too.
class Storeys {
public:
    Storeys() {
        for (float x = 0.01F; x < 8.0F; x += 0.04F) {
            for (float y = -1.5F; y < 1.5F; y += 0.04F) {
                add(x, y, 0.0F, Label::Floor);
                if (x > 2.0F && std::abs(y) < 0.6F) add(x, y, heightAt(x), Label::Floor);
            }
        }
    }
    [[nodiscard]] static float heightAt(float x) { return std::clamp(0.3F * (x - 2.0F), 0.0F, Deck); }
    void add(float x, float y, float z, Label label) {
        m_points.emplace_back(x, y, z);
        m_labels.push_back(label);
    }
    /// A box of 0.2 m x 0.2 m about a place, from one height to another.
    void box(float x, float y, float low, float high) {
        for (float u = -0.1F; u <= 0.1F; u += 0.02F) {
            for (float v = -0.1F; v <= 0.1F; v += 0.02F) {
                for (float z = low; z <= high; z += 0.02F) add(x + u, y + v, z, Label::Unlabelled);
            }
        }
    }
    [[nodiscard]] std::vector<ReportScan> scans() const { return {scanOf(m_points, m_labels)}; }
    [[nodiscard]] OccupancyGrid low(const std::vector<Eigen::Vector3d>& trail) const {
        return gridOf(VoxelEvidence::of(scans()), FloorHeights::of(scans(), trail), reportBands().front());
    }

private:
    std::vector<Eigen::Vector3f> m_points;
    std::vector<Label> m_labels;
};

std::vector<Eigen::Vector3d> upOntoTheDeck() {
    std::vector<Eigen::Vector3d> trail;
    for (float x = 0.2F; x < 7.8F; x += 0.1F) trail.emplace_back(x, 0.0, Storeys::heightAt(x));
    return trail;
}
std::vector<Eigen::Vector3d> besideIt() {
    std::vector<Eigen::Vector3d> trail;
    for (double x = 0.2; x < 7.8; x += 0.1) trail.emplace_back(x, -1.2, 0.0);
    return trail;
}

TEST(Storeys, OnADeckHeightsCountFromTheDeckThoughTheFloorBelowIsSeen) {
    const FloorHeights floor = FloorHeights::of(Storeys().scans(), upOntoTheDeck());
    EXPECT_NEAR(floor.at(1.0, 0.0), 0.0, 0.02);
    EXPECT_NEAR(floor.at(3.5, 0.0), 0.45, 0.04) << "the ramp, not the floor below it";
    EXPECT_NEAR(floor.at(6.5, 0.0), Deck, 0.02);
    EXPECT_NEAR(floor.at(6.5, -1.3), 0.0, 0.02) << "beside it";
    EXPECT_TRUE(floor.seen(6.5, 0.0));
}

TEST(Storeys, ADeckThatRobotsOnlyPassedIsNoFloorOfTheirs) {
    const FloorHeights floor = FloorHeights::of(Storeys().scans(), besideIt());
    EXPECT_NEAR(floor.at(6.5, 0.0), 0.0, 0.02);
}

TEST(Storeys, WhatWasFoundStandsOnTheFloorThatBearsIt) {
    const FloorHeights floor = FloorHeights::of(Storeys().scans(), upOntoTheDeck());
    EXPECT_NEAR(floor.below({6.5, 0.2, Deck + 0.3}), Deck, 0.02);
    EXPECT_NEAR(floor.below({6.5, 0.2, 0.4}), 0.0, 0.02) << "below the deck";
    EXPECT_NEAR(floor.below({6.5, 0.2, Deck - 0.05}), Deck, 0.02) << "within what its place is known to";
    EXPECT_NEAR(floor.below({50.0, 0.0, 0.5}), floor.at(50.0, 0.0), 1e-9) << "as at the nearest place";
}

TEST(Storeys, TheLowerMapShowsWhatStandsOnTheDeck) {
    Storeys scene;
    scene.box(7.0F, 0.0F, Deck, Deck + 0.5F);
    const OccupancyGrid map = scene.low(upOntoTheDeck());
    EXPECT_EQ(map.at(7.0, 0.0).state, State::Occupied);
    EXPECT_EQ(map.at(6.0, 0.0).state, State::Free) << "the deck itself is no obstacle";
}

TEST(Slices, TheLowerMapShowsWhatIsAtThirtyCentimetresAndNothingLower) {
    Storeys scene;
    scene.box(1.0F, 0.0F, 0.02F, 0.15F);
    scene.box(1.5F, 1.0F, 0.28F, 0.32F);
    const OccupancyGrid map = scene.low(besideIt());
    EXPECT_NE(map.at(1.0, 0.0).state, State::Occupied) << "robots drive over it, or see it otherwise";
    EXPECT_EQ(map.at(1.5, 1.0).state, State::Occupied) << "a bar";
}

TEST(Slices, APostOnARampIsShownByItsHeightAboveTheRamp) {
    Storeys scene;
    scene.box(4.0F, 0.0F, Storeys::heightAt(4.0F), Storeys::heightAt(4.0F) + 0.4F);
    scene.box(4.0F, 0.4F, Storeys::heightAt(4.0F), Storeys::heightAt(4.0F) + 0.15F);
    const OccupancyGrid map = scene.low(upOntoTheDeck());
    EXPECT_EQ(map.at(4.0, 0.0).state, State::Occupied);
    EXPECT_NE(map.at(4.0, 0.4).state, State::Occupied)
        << "0.75 m above the hall's floor, but low on the ramp";
    EXPECT_NE(map.at(3.0, 0.0).state, State::Occupied) << "the ramp itself";
}

TEST(Slices, ABandIsWholeCubes) {
    // A band of 10 cm touches two cubes of 5 cm, or three where the floor is not on their grid.
    std::vector<Eigen::Vector3f> points;
    std::vector<Label> labels;
    const float ground = 0.02F;
    for (float x = 0.01F; x < 2.0F; x += 0.04F) {
        for (float y = -1.0F; y < 1.0F; y += 0.04F) points.emplace_back(x, y, ground);
    }
    labels.assign(points.size(), Label::Floor);
    for (const float above : {0.20F, 0.24F, 0.36F, 0.41F}) {
        points.emplace_back(0.51F + 2.0F * (above - 0.2F), 0.01F, ground + above);
        labels.push_back(Label::Wall);
    }
    const std::vector<ReportScan> scans = {scanOf(points, labels)};
    const std::vector<Eigen::Vector3d> trail = {{0.5, 0.0, ground}};
    const OccupancyGrid map =
        gridOf(VoxelEvidence::of(scans), FloorHeights::of(scans, trail), reportBands().front());
    const auto shown = [&](float above) {
        return map.at(0.51F + 2.0F * (above - 0.2F), 0.01F).state == State::Occupied;
    };
    EXPECT_FALSE(shown(0.20F)) << "in the cube from 0.20 m on, of which the band has nothing";
    EXPECT_TRUE(shown(0.24F)) << "in that from 0.25 m on";
    EXPECT_TRUE(shown(0.36F)) << "in that up to 0.40 m";
    EXPECT_FALSE(shown(0.41F));
}

}  // namespace
}  // namespace leitstand::test
