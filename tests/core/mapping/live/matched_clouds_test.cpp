#include "core/mapping/live/map/matched_clouds.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/core/mapping/live/mapped_room.h"
#include "tests/core/mapping/live/page_memory.h"

namespace leitstand::test {
namespace {

PointCloud cloudOf(int number) {
    PointCloud cloud;
    for (int i = 0; i < 100; ++i) {
        const auto at = static_cast<float>(number) + 0.01F * static_cast<float>(i);
        cloud.points.emplace_back(at, -at, 0.5F * at);
        cloud.normals.emplace_back(Eigen::Vector3f(at, 1.0F, 0.1F).normalized());
        cloud.labels.push_back(i % 2 == 0 ? Label::Floor : Label::Wall);
    }
    return cloud;
}

/// What nobody expects to be asked for.
PointCloud lost() {
    ADD_FAILURE() << "the store has it";
    return cloudOf(0);
}

bool same(const PointCloud& a, const PointCloud& b) {
    return a.points == b.points && a.normals == b.normals && a.labels == b.labels;
}

std::size_t inMemory(const std::vector<MatchedCloudPtr>& clouds) {
    return static_cast<std::size_t>(
        std::count_if(clouds.begin(), clouds.end(), [](const auto& cloud) { return cloud->memory() > 0; }));
}

TEST(MatchedClouds, OfThoseThatWereUsedLatelyAreInMemoryAndTheOthersComeBackBitForBit) {
    const auto store = std::make_shared<PageMemory>();
    const MatchedClouds clouds(store, 3);
    std::vector<MatchedCloudPtr> all;
    std::vector<PointCloud> before;
    for (int i = 0; i < 10; ++i) {
        all.push_back(clouds.keep(cloudOf(i), &lost));
        before.push_back(all.back()->unpacked());
    }
    EXPECT_EQ(inMemory(all), 3U);
    EXPECT_EQ(store->pages.size(), 7U);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i]->size(), 100U) << "known without the store";
        EXPECT_TRUE(same(all[i]->unpacked(), before[i])) << i;
        EXPECT_GT(all[i]->memory(), 0U);
    }
    EXPECT_EQ(inMemory(all), 3U);
    EXPECT_EQ(store->puts, 10) << "each once";
    all.clear();
    EXPECT_TRUE(store->pages.empty()) << "nobody asks for them any more";
}

TEST(MatchedClouds, OneThatIsUsedAgainAndAgainStays) {
    const auto store = std::make_shared<PageMemory>();
    const MatchedClouds clouds(store, 2);
    const MatchedCloudPtr often = clouds.keep(cloudOf(0), &lost);
    std::vector<MatchedCloudPtr> others;
    for (int i = 1; i < 10; ++i) {
        others.push_back(clouds.keep(cloudOf(i), &lost));
        (void)often->unpacked();
    }
    EXPECT_EQ(store->reads, 0);
    EXPECT_GT(often->memory(), 0U);
}

TEST(MatchedClouds, WhereTheStoreHasNoSpaceTheyStayInMemoryUntilItHas) {
    const auto store = std::make_shared<PageMemory>();
    const MatchedClouds clouds(store, 2);
    store->full = true;
    std::vector<MatchedCloudPtr> all;
    for (int i = 0; i < 5; ++i) all.push_back(clouds.keep(cloudOf(i), &lost));
    EXPECT_EQ(inMemory(all), 5U);
    EXPECT_EQ(all.front()->unpacked().size(), 100U);
    store->full = false;
    all.push_back(clouds.keep(cloudOf(5), &lost));
    EXPECT_EQ(inMemory(all), 2U);
}

TEST(MatchedClouds, WhatCannotBeReadIsMadeAgain) {
    const auto store = std::make_shared<PageMemory>();
    const MatchedClouds clouds(store, 1);
    int made = 0;
    const MatchedCloudPtr base = clouds.keep(cloudOf(1), [&made] {
        ++made;
        return cloudOf(1);
    });
    // One that is made of another one, as what is inside a crop is.
    const MatchedCloudPtr part = clouds.keep(cloudOf(2), [base] { return base->unpacked(); });
    const MatchedCloudPtr newest = clouds.keep(cloudOf(3), &lost);
    store->unreadable = true;
    EXPECT_TRUE(same(part->unpacked(), MatchedCloud(cloudOf(1)).unpacked()));
    EXPECT_EQ(made, 1);
}

TEST(MatchedClouds, WhatIsPromisedIsMadeOnceWhenItIsUsedFirst) {
    const auto store = std::make_shared<PageMemory>();
    const MatchedClouds clouds(store, 1);
    int made = 0;
    const MatchedCloudPtr promised = clouds.promise([&made] {
        ++made;
        return cloudOf(1);
    });
    EXPECT_FALSE(promised->size()) << "nobody knows yet";
    EXPECT_EQ(promised->memory(), 0U);
    EXPECT_EQ(made, 0);
    EXPECT_TRUE(same(promised->unpacked(), MatchedCloud(cloudOf(1)).unpacked()));
    EXPECT_EQ(promised->size(), 100U);
    const MatchedCloudPtr newest = clouds.keep(cloudOf(2), &lost);
    EXPECT_TRUE(same(promised->unpacked(), MatchedCloud(cloudOf(1)).unpacked())) << "from the store";
    EXPECT_EQ(made, 1);
}

TEST(MatchedClouds, WithoutAStoreAllStay) {
    const MatchedClouds clouds(nullptr, 1);
    const MatchedCloudPtr first = clouds.keep(cloudOf(1), &lost), second = clouds.keep(cloudOf(2), &lost);
    EXPECT_EQ(inMemory({first, second}), 2U);
}

/// There, and back to where it began.
std::vector<Pose> thereAndBack() {
    std::vector<Pose> way;
    for (int i = 0; i <= 8; ++i) way.push_back(poseFrom({-1.6 + 0.4 * i, 0.0, 0.9}, 0, 0, 0));
    for (int i = 7; i >= 0; --i) way.push_back(poseFrom({-1.6 + 0.4 * i, 0.1, 0.9}, 0, 0, degrees(3)));
    return way;
}

TEST(PagedMap, ARobotThatComesBackMatchesBitForBitWhatWasLetGo) {
    MappedRoom whole, paged;
    LiveSettings settings;
    settings.local.scans = 3;
    whole.mapper = LiveMapper("station", settings);
    const auto store = std::make_shared<PageMemory>();
    settings.pages = store;
    settings.inMemory = 3;
    paged.mapper = LiveMapper("station", settings);
    for (const Pose& place : thereAndBack()) {
        const MapUpdate a = whole.add(place), b = paged.add(place);
        ASSERT_EQ(a.localisation.doubts, b.localisation.doubts);
        ASSERT_EQ(a.localisation.baseInMap.matrix(), b.localisation.baseInMap.matrix());
        ASSERT_EQ(a.localisation.icp.rms, b.localisation.icp.rms);
    }
    EXPECT_GT(store->puts, 10) << "what is far was let go";
    EXPECT_GT(store->reads, 5) << "and came back";
    EXPECT_GT(whole.mapper.map()->scans.size(), 12U);
    // So do the operator's decisions, on what was let go, too.
    MapCrop area;
    area.ceiling = 0.5;
    for (MappedRoom* room : {&whole, &paged}) {
        ASSERT_TRUE(room->mapper.retry(2, {}, room->now).ok());
        room->mapper.setCrop(area);
    }
    const LiveMapPtr a = whole.mapper.map(), b = paged.mapper.map();
    ASSERT_EQ(a->scans.size(), b->scans.size());
    for (std::size_t i = 0; i < a->scans.size(); ++i) {
        EXPECT_EQ(a->scans[i].pose.scanInMap.matrix(), b->scans[i].pose.scanInMap.matrix()) << i;
        EXPECT_TRUE(same(a->scans[i].reduced->unpacked(), b->scans[i].reduced->unpacked())) << i;
    }
}

}  // namespace
}  // namespace leitstand::test
