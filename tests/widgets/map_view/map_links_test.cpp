#include "widgets/map_view/overlays/map_links.h"

#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "core/mapping/comparison/map_changes.h"
#include "tests/widgets/map_view/shown_view.h"
#include "widgets/map_view/scene/points/map_colours.h"

namespace leitstand::test {
namespace {

/// Two scans of a few points, 4 m apart.
MapPtr twoScans() {
    auto map = std::make_shared<Map>();
    for (std::uint64_t id = 1; id <= 2; ++id) {
        auto scan = std::make_shared<Scan>();
        for (int i = 0; i < 50; ++i) scan->points.emplace_back(1.0F, 0.02F * static_cast<float>(i), 0.0F);
        scan->labels.assign(scan->points.size(), Label::Wall);
        MapScan placed;
        placed.scan = scan;
        placed.id = id;
        placed.poseInMap.translation().x() = 4.0 * static_cast<double>(id);
        map->scans.push_back(std::move(placed));
    }
    return map;
}

QRgb rgbOf(Rgba colour) {
    return qRgb(colour.r, colour.g, colour.b);
}

struct LinkedView : testing::Test {
    [[nodiscard]] int pixels(Rgba colour) { return countPixels(view.onScreen(), rgbOf(colour)); }
    ShownView view{twoScans(), settingsOf(MapLook::Points)};
    const MapColours& colours = mapColours(Theme::Dark);
};

TEST_F(LinkedView, ALinkIsALineAsItStands) {
    ASSERT_TRUE(view.settle());
    EXPECT_EQ(pixels(colours.link), 0);
    view->setLinks({{1, 2, MapLink::Standing::Counts}});
    const int solid = pixels(colours.link);
    EXPECT_GT(solid, 50);
    view->setLinks({{1, 2, MapLink::Standing::Open}});
    EXPECT_EQ(pixels(colours.link), 0);
    EXPECT_GT(pixels(colours.openLink), 20);
    EXPECT_LT(pixels(colours.openLink), solid) << "dashed";
    view->setLinks({{1, 2, MapLink::Standing::Refused}});
    EXPECT_GT(pixels(colours.refusedLink), 10);
    view->setLinks({});
    EXPECT_EQ(pixels(colours.refusedLink), 0);
}

TEST_F(LinkedView, WhatLeadsToAScanThatIsNotShownIsNone) {
    ASSERT_TRUE(view.settle());
    view->setLinks({{1, 7, MapLink::Standing::Counts}, {0, 0, MapLink::Standing::Counts}});
    EXPECT_EQ(pixels(colours.link), 0);
    view->setLinks({{1, 2, MapLink::Standing::Counts}});
    view->setVisible(std::vector<bool>{true, false});
    ASSERT_TRUE(view.settle());
    EXPECT_EQ(pixels(colours.link), 0);
}

TEST_F(LinkedView, WhatChangedStandsOutOfTheRest) {
    ASSERT_TRUE(view.settle());
    const int wall = pixels(labelColour(Label::Wall));
    EXPECT_GT(wall, 0);
    auto changes = std::make_shared<MapChanges>();
    ChangedThing came, went;
    came.isNew = true;
    for (int i = 0; i < 20; ++i) {
        came.cells.emplace_back(6.0F, 0.1F * static_cast<float>(i), 0.5F);
        went.cells.emplace_back(7.0F, 0.1F * static_cast<float>(i), 0.5F);
    }
    changes->things = {came, went};
    view->setChanges(changes);
    ASSERT_TRUE(view.settle());
    EXPECT_GT(pixels(colours.newThing), 50);
    EXPECT_GT(pixels(colours.goneThing), 50);
    EXPECT_LT(pixels(labelColour(Label::Wall)), wall) << "but for the legend";
    view->setChanges(nullptr);
    ASSERT_TRUE(view.settle());
    EXPECT_EQ(pixels(colours.newThing), 0);
    EXPECT_EQ(pixels(labelColour(Label::Wall)), wall);
}

}  // namespace
}  // namespace leitstand::test
