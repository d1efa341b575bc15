// Parts of the map that the operator moves by hand.
#include "core/mapping/live/loops/submap.h"

#include <set>
#include <stop_token>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/mapping/live/two_in_a_room.h"

namespace leitstand::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Two parts of a map of one room, of which nobody knows how they lie to each other.
struct TwoParts : TwoRobotsInARoom {
    TwoParts() {
        mapper.beginPart("second");
        for (int i = 0; i < 5; ++i) {
            const Pose here = poseFrom({1.5 - 0.45 * i, 1.0 - 0.3 * i, 0.9}, 0, 0, degrees(200 + 4 * i));
            const MapUpdate update = add(seen(here));
            if (update.keyScan) second.emplace_back(update.keyScan->id, here);
        }
    }
    [[nodiscard]] SubmapOnMap part() {
        return {mapper.map(), submapOf(*mapper.map(), second.front().first, SubmapKind::Part)};
    }
    /// What brings the second part to where it was taken.
    [[nodiscard]] Pose truth() {
        const LiveMapPtr map = mapper.map();
        const Pose roomInMap =
            map->scans.front().pose.scanInMap * poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse();
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.id == second.front().first)
                return roomInMap * second.front().second * scan.pose.scanInMap.inverse();
        }
        return Pose::Identity();
    }
    /// Where the part's first scan is then.
    [[nodiscard]] Pose toward(const Pose& moved) {
        const LiveMapPtr map = mapper.map();
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.id == second.front().first) return moved * scan.pose.scanInMap;
        }
        return moved;
    }
    /// The truth, off by so much about the middle of the part.
    [[nodiscard]] Pose near(const SubmapOnMap& part, double metres, double angle) {
        const Eigen::Translation3d middle(truth() * part.middle());
        return middle * poseFrom({metres, -metres, 0}, 0, 0, angle) * middle.inverse() * truth();
    }
};

TEST(Submaps, AreARunARobotsAStoreyOrAPart) {
    TwoParts room;
    const LiveMapPtr held = room.mapper.map();
    const LiveMap& map = *held;
    std::set<std::uint64_t> firsts, seconds;
    for (const LiveKeyScan& scan : map.scans) (scan.part == 0 ? firsts : seconds).insert(scan.id);
    ASSERT_THAT(firsts, SizeIs(6));
    ASSERT_THAT(seconds, SizeIs(5));
    EXPECT_EQ(submapOf(map, *seconds.begin(), SubmapKind::Part), seconds);
    EXPECT_EQ(submapOf(map, *firsts.begin(), SubmapKind::Part), firsts);
    EXPECT_EQ(submapOf(map, *seconds.rbegin(), SubmapKind::Robot), seconds);
    EXPECT_THAT(submapOf(map, 5, SubmapKind::FromHere), ElementsAre(5, 6)) << "the other robot's stay";
    EXPECT_EQ(submapOf(map, 1, SubmapKind::Storey), firsts) << "what lies aside is of no storey of the map";
    EXPECT_THAT(submapOf(map, 99, SubmapKind::Part), IsEmpty());
    LiveMap up = map;  // two storeys, and another part aside, at the height of the lower one
    const std::size_t below = up.scans.size();
    for (std::size_t i = 0; i < below; ++i) {
        if (up.scans[i].part != 0) continue;
        up.scans.push_back(up.scans[i]);
        up.scans.back().id += 100;
        up.scans.back().pose.scanInMap.translation().z() += 3.0;
    }
    EXPECT_EQ(submapOf(up, *firsts.begin(), SubmapKind::Storey), firsts);
    EXPECT_EQ(*submapOf(up, *firsts.begin() + 100, SubmapKind::Storey).begin(), *firsts.begin() + 100);
}

TEST(Submaps, TellHowTheyLieOnTheRest) {
    TwoParts room;
    const SubmapOnMap part = room.part();
    const SubmapFit aside = part.at(Pose::Identity()), right = part.at(room.truth()),
                    off = part.at(room.near(part, 0.15, 0));
    EXPECT_LT(aside.overlap, 0.05);
    EXPECT_GT(right.overlap, 0.7);
    EXPECT_LT(right.seam, 0.08);
    EXPECT_GT(off.seam, 1.5 * right.seam);
    EXPECT_EQ(part.places(room.truth()).size(), 5U);
}

TEST(Submaps, SnapFromWhereTheyWereDragged) {
    TwoParts room;
    const SubmapOnMap part = room.part();
    const auto snapped = part.snapped(room.near(part, 0.4, degrees(10)));
    ASSERT_TRUE(snapped);
    for (const auto& [id, place] : part.places(*snapped)) {
        const Pose true_ = part.places(room.truth()).at(id);
        EXPECT_LT(distanceBetween(place, true_), 0.03) << id;
        EXPECT_LT(angleBetween(place, true_), degrees(1)) << id;
    }
    EXPECT_FALSE(part.snapped(Pose::Identity())) << "nothing of the rest is there";
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(part.snapped(room.near(part, 0.4, degrees(10)), {{}, stop.get_token()}));
    const SubmapOnMap cancelled(room.mapper.map(), part.submap(), {}, {{}, stop.get_token()});
    EXPECT_EQ(cancelled.at(room.truth()).overlap, 0.0);
}

TEST(Submaps, WhatIsMovedIsLinkedThereAndTheMapFollows) {
    TwoParts room;
    const SubmapOnMap part = room.part();
    const auto before = room.poses();
    const auto links = room.mapper.moveTo(room.second.front().first, SubmapKind::Part,
                                          room.toward(room.near(part, 0.2, degrees(4))), room.now);
    ASSERT_TRUE(links) << links.error().text;
    EXPECT_THAT(links->links, SizeIs(testing::Ge(3U)));
    EXPECT_THAT(links->links, Each(Field(&Link::kind, LinkKind::Operator)));
    EXPECT_THAT(links->links, Each(Field(&Link::active, true)));
    const std::uint64_t reported = room.log.publish(*links, "/leitstand/scan_links");
    ASSERT_TRUE(room.solveAll());
    EXPECT_LT(room.worst(), 0.03);
    EXPECT_THAT(room.mapper.map()->scans, Each(Field(&LiveKeyScan::part, 0U))) << "one map";
    EXPECT_TRUE(alike(room.poses(), room.log.poses()));
    (void)room.log.undo(reported, room.mapper);
    (void)room.solveAll();
    EXPECT_TRUE(alike(room.poses(), before)) << "taken back";
}

TEST(Submaps, OneScanAloneIsComparedWithTheOthersPartAndBringsItsOwnAlong) {
    TwoParts room;
    const std::uint64_t id = room.second.front().first;
    const SubmapOnMap alone(room.mapper.map(), submapOf(*room.mapper.map(), id, SubmapKind::Scan),
                            leftBehind(*room.mapper.map(), id, SubmapKind::Scan));
    ASSERT_THAT(alone.submap(), testing::ElementsAre(id));
    EXPECT_EQ(alone.at(Pose::Identity()).overlap, 0.0) << "what its robot scanned beside it does not count";
    EXPECT_GT(alone.at(room.truth()).overlap, 0.6);
    const auto snapped = alone.snapped(room.near(alone, 0.3, degrees(6)));
    ASSERT_TRUE(snapped);
    const auto links = room.mapper.moveTo(id, SubmapKind::Scan, alone.places(*snapped).at(id), room.now);
    ASSERT_TRUE(links) << links.error().text;
    ASSERT_THAT(links->links, SizeIs(1));
    EXPECT_EQ(links->links.front().to, id);
    (void)room.log.publish(*links, "/leitstand/scan_links");
    ASSERT_TRUE(room.solveAll());
    EXPECT_LT(room.worst(), 0.03);
    EXPECT_THAT(room.mapper.map()->scans, Each(Field(&LiveKeyScan::part, 0U))) << "one map";
}

TEST(Submaps, WhatDoesNotFitIsNotMoved) {
    TwoParts room;
    const SubmapOnMap part = room.part();
    const auto links = room.mapper.moveTo(room.second.front().first, SubmapKind::Part,
                                          room.toward(room.near(part, 0.0, degrees(90))), room.now);
    ASSERT_FALSE(links);
    EXPECT_THAT(links.error().text, HasSubstr("does not fit"));
    EXPECT_FALSE(room.mapper.problem()) << "nothing is to be solved";
}

TEST(Submaps, ARunThatDriftedIsBroughtBackToWhereItStarted) {
    LiveSettings settings = inARoom();
    settings.loops.apart = 0.3;
    MappedRoom room(settings);
    std::vector<Pose> taken;
    for (int i = 0; i < 9; ++i) {
        taken.push_back(poseFrom({-1.4 + 0.35 * i, 0.2, 0.9}, 0, 0, 0));
        ASSERT_TRUE(room.add(taken.back()).keyScan) << i;
    }
    // As a map that drifted: from the fifth on all lie 0.5 m aside, and what was matched does not tell.
    std::vector<ScanPose> poses = room.poses();
    for (std::size_t i = 4; i < poses.size(); ++i)
        poses[i].scanInMap = poseFrom({0, 0.5, 0}, 0, 0, 0) * poses[i].scanInMap;
    room.mapper.follow(poses);
    const LiveMapPtr map = room.mapper.map();
    const SubmapOnMap run(map, submapOf(*map, poses[4].scan, SubmapKind::FromHere));
    ASSERT_THAT(run.submap(), SizeIs(5));
    const auto snapped = run.snapped(poseFrom({0, -0.3, 0}, 0, 0, 0));
    ASSERT_TRUE(snapped);
    // One that enters while it is dragged comes along.
    taken.push_back(poseFrom({-1.4 + 0.35 * 9, 0.2, 0.9}, 0, 0, 0));
    ASSERT_TRUE(room.add(taken.back()).keyScan);
    const auto links =
        room.mapper.moveTo(poses[4].scan, SubmapKind::FromHere, *snapped * poses[4].scanInMap, room.now);
    ASSERT_TRUE(links) << links.error().text;
    for (const Link& link : links->links) {
        const Pose wanted = taken[link.from - 1].inverse() * taken[link.to - 1];
        EXPECT_LT(link.from, 5U) << "what is moved is held by what is not";
        EXPECT_LT(distanceBetween(link.pose, wanted), 0.03) << link.from << " to " << link.to;
    }
    ASSERT_TRUE(room.solveAll());
    const Pose roomInMap = room.poses().front().scanInMap * taken.front().inverse();
    for (std::size_t i = 0; i < taken.size(); ++i)
        EXPECT_LT(distanceBetween(room.poses()[i].scanInMap, roomInMap * taken[i]), 0.03) << i;
}

}  // namespace
}  // namespace leitstand::test
