#include "app/services/layouts/layout_sights.h"

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

constexpr MapSight Overview{MapLook::Points, MapFollow::Free}, HeadingUp{MapLook::Top, MapFollow::Above},
    Chase{MapLook::Voxels, MapFollow::Behind};

WindowLayout layout(const char* name, const LayoutMap& map = {}) {
    WindowLayout one;
    one.name = name;
    one.map = map;
    return one;
}

const WindowLayout Drive = layout("drive", {MapLook::Top, MapFollow::Above}),
                   Explore = layout("explore", {std::nullopt, MapFollow::Free}),
                   Map = layout("map", {std::nullopt, MapFollow::Free}), Silent = layout("silent");

TEST(LayoutSights, ShowWhatTheLayoutSaysAtFirst) {
    LayoutSights sights(Overview);
    EXPECT_EQ(sights.enter(Drive, Overview), HeadingUp);
    EXPECT_EQ(sights.enter(Explore, HeadingUp), Overview) << "its look is the operator's own";
}

TEST(LayoutSights, ThenWhatTheOperatorLastHadThere) {
    LayoutSights sights(Overview);
    (void)sights.enter(Drive, Overview);
    EXPECT_EQ(sights.enter(Explore, Chase), Overview);
    EXPECT_EQ(sights.enter(Drive, HeadingUp), Chase);
    EXPECT_EQ(sights.enter(Explore, Chase), HeadingUp);
}

TEST(LayoutSights, ALookOfOnesOwnIsThatOfOtherLayoutsThatLeaveItOpen) {
    LayoutSights sights(Overview);
    (void)sights.enter(Explore, Overview);
    const MapSight cubes{MapLook::Voxels, MapFollow::Free};
    EXPECT_EQ(sights.enter(Map, cubes), cubes);
    EXPECT_EQ(sights.enter(Drive, cubes), HeadingUp);
    EXPECT_EQ(sights.own(HeadingUp).look, MapLook::Voxels) << "Drive's is Drive's own";
}

TEST(LayoutSights, ALayoutThatSaysNothingLeavesTheMapToTheOneBefore) {
    LayoutSights sights(Overview);
    const MapSight before = sights.enter(Drive, Overview);
    EXPECT_EQ(sights.enter(Silent, before), HeadingUp);
    EXPECT_EQ(sights.own(before), Overview);
    EXPECT_EQ(sights.enter(Explore, Chase), Overview);
    EXPECT_EQ(sights.enter(Drive, Overview), Chase) << "it was still Drive's";
}

TEST(LayoutSights, WithoutAnyThatSaysSomethingTheMapIsTheOperators) {
    LayoutSights sights(Overview);
    EXPECT_EQ(sights.enter(Silent, Overview), Overview);
    EXPECT_EQ(sights.own(Chase), Chase);
}

TEST(LayoutSights, AForgottenLayoutIsAsItsFileSays) {
    LayoutSights sights(Overview);
    (void)sights.enter(Drive, Overview);
    (void)sights.enter(Explore, Chase);
    sights.forget("drive");
    EXPECT_EQ(sights.enter(Drive, Overview), HeadingUp);
    sights.forget("drive");
    EXPECT_EQ(sights.enter(Drive, Chase), HeadingUp) << "also the one in use";
}

}  // namespace
}  // namespace leitstand::test
