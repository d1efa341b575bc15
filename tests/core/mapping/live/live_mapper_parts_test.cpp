#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/mapping/live/two_in_a_room.h"

namespace leitstand::test {
namespace {

using testing::Each;
using testing::Field;
using testing::IsEmpty;
using testing::Not;

TEST(LiveMapperParts, ARobotThatNobodyPlacedWaitsUntilItIsToBeginAPart) {
    TwoRobotsInARoom room;
    EXPECT_FALSE(room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0))).keyScan);
    room.mapper.beginPart("second");
    const MapUpdate update = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(update.keyScan);
    EXPECT_EQ(update.localisation.trust, ScanTrust::Certain);
    EXPECT_EQ(update.keyScan->matched, 0U) << "it was registered against nothing";
    EXPECT_LT(update.keyScan->scanInMap.translation().y(), -20.0) << "beside the map";
    EXPECT_EQ(room.mapper.map()->scans.back().part, update.keyScan->id);
    ASSERT_TRUE(room.mapper.fix("second"));
    EXPECT_EQ(room.mapper.fix("second")->part, update.keyScan->id);
    EXPECT_EQ(room.mapper.fix("kurt3d")->part, 0U);
}

TEST(LiveMapperParts, OneThatIsLostBeginsAPartWithTheNextScanThatDoesNotFit) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto first = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(first.keyScan);
    room.mapper.beginPart("second");
    const auto fits = room.add(room.seen(poseFrom({1.1, 1, 0.9}, 0, 0, 0)));
    EXPECT_EQ(fits.localisation.trust, ScanTrust::Certain);
    EXPECT_EQ(room.mapper.fix("second")->part, first.keyScan->id) << "it is not lost";
    // Carried: its odometry has it where it was.
    const auto carried = [&](double y) {
        LiveScan live = room.seen(poseFrom({-1.5, y, 0.9}, 0, 0, degrees(170)));
        auto scan = std::make_shared<Scan>(*live.scan);
        scan->sensorInOdom = room.seen(poseFrom({1.1, 1, 0.9}, 0, 0, 0)).scan->sensorInOdom;
        live.scan = std::move(scan);
        return live;
    };
    EXPECT_EQ(room.add(carried(-1.2)).localisation.trust, ScanTrust::Uncertain);
    EXPECT_FALSE(room.mapper.isAstray("second")) << "by odometry it did not go far";
    room.mapper.beginPart("second");
    const auto begun = room.add(carried(-1.2));
    ASSERT_TRUE(begun.keyScan);
    EXPECT_EQ(begun.localisation.trust, ScanTrust::Certain);
    EXPECT_EQ(begun.keyScan->matched, 0U);
    EXPECT_EQ(room.mapper.fix("second")->part, begun.keyScan->id);
    const auto goesOn = room.add(carried(-1.2));
    EXPECT_EQ(goesOn.localisation.trust, ScanTrust::Certain) << "and its part goes on";
    EXPECT_EQ(room.mapper.fix("second")->part, begun.keyScan->id);
}

TEST(LiveMapperParts, ItsPartGrowsByItselfAndNothingClosesIntoTheOtherUnasked) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    for (int i = 0; i < 4; ++i) {
        const MapUpdate update = room.add(room.seen(poseFrom({1.5 - 0.4 * i, 1, 0.9}, 0, 0, 0)));
        ASSERT_TRUE(update.keyScan) << i;
        EXPECT_EQ(update.localisation.trust, ScanTrust::Certain) << i;
        EXPECT_FALSE(update.loop) << i;
    }
    EXPECT_THAT(room.scansOf("kurt3d"), Each(Field(&LiveKeyScan::part, 0U)));
    const auto second = room.scansOf("second");
    EXPECT_THAT(second, Each(Field(&LiveKeyScan::part, second.front().id)));
    EXPECT_FALSE(room.mapper.problem());
}

TEST(LiveMapperParts, ScansWhereBothSawTheSameAreAQuestionAndTheAnswerBringsThePartsTogether) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto question = room.explore(8);
    ASSERT_TRUE(question);
    EXPECT_THAT(question->links, Not(IsEmpty()));
    EXPECT_THAT(question->links, Each(Field(&Link::kind, LinkKind::Session)));
    EXPECT_THAT(question->links, Each(Field(&Link::active, false)));
    const auto before = room.poses();
    EXPECT_FALSE(room.mapper.problem()) << "unanswered nothing moves";
    room.answer(*question, true);
    ASSERT_TRUE(room.solveAll());
    EXPECT_LT(room.worst(), 0.03);
    for (std::size_t i = 0; i < 6; ++i)
        EXPECT_LT(distanceBetween(before[i].scanInMap, room.poses()[i].scanInMap), 0.02) << i;
    EXPECT_THAT(room.mapper.map()->scans, Each(Field(&LiveKeyScan::part, 0U))) << "one map";
    EXPECT_TRUE(alike(room.poses(), room.log.poses()));
    const MapUpdate next = room.add(room.seen(poseFrom({-1.5, -1.2, 0.9}, 0, 0, degrees(240))));
    EXPECT_EQ(next.localisation.trust, ScanTrust::Certain) << "the robot goes on in the other's map";
}

TEST(LiveMapperParts, PartsThatCameTogetherAreLinkedWhereverTheySawTheSame) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto question = room.explore(8);
    ASSERT_TRUE(question);
    // As in a building: a room is so small that all of it hangs together over what was answered.
    LiveSettings settings = inARoom();
    settings.loops.sameAge = 0.5;
    LiveMapper mapper = room.log.readAgain(settings);
    const auto poses = [&] {
        std::vector<ScanPose> all;
        const LiveMapPtr map = mapper.map();
        for (const LiveKeyScan& scan : map->scans) all.push_back(scan.pose);
        return all;
    };
    const auto answer = [&](bool same) {
        ScanLinksSample reported = *question;
        for (Link& link : reported.links) {
            link.kind = LinkKind::Operator;
            link.active = same;
        }
        mapper.restore(reported);
        const auto problem = mapper.problem();
        ASSERT_TRUE(problem);
        (void)mapper.settle(solve(*problem), room.now);
    };
    const auto before = poses();
    EXPECT_FALSE(mapper.meetsMore());
    answer(true);
    std::size_t links = 0;
    for (int i = 0; mapper.meetsMore(); ++i) {
        ASSERT_LT(i, 20);
        const auto more = mapper.meetMore(room.now);
        if (!more) continue;
        EXPECT_FALSE(mapper.meetsMore()) << "said all at once";
        links += more->links.size();
        EXPECT_THAT(more->links, Each(Field(&Link::kind, LinkKind::Loop)));
        EXPECT_THAT(more->links, Each(Field(&Link::active, true)));
    }
    EXPECT_GE(links, 2U);
    const auto together = poses();
    answer(false);
    EXPECT_TRUE(alike(poses(), before)) << "what was found by the answer falls with it";
    EXPECT_FALSE(mapper.meetsMore()) << "nothing is looked for between what came apart";
    answer(true);
    for (std::size_t i = 0; i < together.size(); ++i)
        EXPECT_LT(distanceBetween(poses()[i].scanInMap, together[i].scanInMap), 0.02) << "it holds again";
}

TEST(LiveMapperParts, TakenBackThePartLiesWhereItWas) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto question = room.explore(8);
    ASSERT_TRUE(question);
    const auto before = room.poses();
    room.answer(*question, true);
    ASSERT_TRUE(room.solveAll());
    room.answer(*question, false);
    ASSERT_TRUE(room.solveAll());
    ASSERT_TRUE(alike(room.poses(), before));
    EXPECT_NE(room.mapper.map()->scans.back().part, 0U);
    EXPECT_FALSE(room.explore(3)) << "it is not asked again";
}

TEST(LiveMapperParts, WhatIsDrawnAroundTheMapCutsNothingOutOfAnotherPart) {
    TwoRobotsInARoom room;
    MapCrop area;
    area.polygon = {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
    area.ceiling = 1.0;
    room.mapper.setCrop(area);
    room.mapper.beginPart("second");
    const MapUpdate update = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(update.keyScan);
    EXPECT_EQ(update.keyScan->scan->points.size(), room.mapper.map()->scans.back().scan->points.size());
    // One that is put there by hand, too.
    room.mapper.place("second", room.mapper.fix("second")->baseInMap * poseFrom({-0.4, 0, 0}, 0, 0, 0));
    const MapUpdate next = room.add(room.seen(poseFrom({1.1, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(next.keyScan);
    EXPECT_EQ(next.localisation.trust, ScanTrust::Certain);
    EXPECT_EQ(room.mapper.map()->scans.back().part, update.keyScan->id);
}

TEST(LiveMapperParts, WhatIsPutIntoAYoungPartIsLinkedWithThatAlone) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const MapUpdate first = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    room.mapper.place("second", room.mapper.fix("second")->baseInMap * poseFrom({-0.4, 0, 0}, 0, 0, 0));
    const MapUpdate next = room.add(room.seen(poseFrom({1.1, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(next.links);
    EXPECT_THAT(next.links->links, Each(Field(&Link::from, first.keyScan->id)));
    ASSERT_TRUE(room.mapper.retry(next.keyScan->id, {}, room.now));
    const auto again = room.mapper.takeLinks();
    ASSERT_TRUE(again);
    for (const Link& link : again->links) {
        EXPECT_TRUE(!link.active || link.from == first.keyScan->id);
    }
}

TEST(LiveMapperParts, ARobotWhosePartWasRejectedBeginsAnotherOne) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const MapUpdate first = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(room.mapper.reject(first.keyScan->id, room.now));
    const MapUpdate next = room.add(room.seen(poseFrom({1.1, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(next.keyScan);
    EXPECT_EQ(next.localisation.trust, ScanTrust::Certain);
    EXPECT_EQ(room.mapper.map()->scans.back().part, next.keyScan->id);
}

TEST(LiveMapperParts, ARobotOfTheFirstPartThatWasRejectedBeginsOneThatNoAreaCuts) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const MapUpdate other = room.add(room.seen(poseFrom({1.5, 1, 0.9}, 0, 0, 0)));
    ASSERT_TRUE(other.keyScan);
    MapCrop area;
    area.polygon = {{-9, -9}, {9, -9}, {9, 9}, {-9, 9}};
    area.ceiling = 1.0;
    room.mapper.setCrop(area);
    for (const LiveKeyScan& scan : room.scansOf("kurt3d")) ASSERT_TRUE(room.mapper.reject(scan.id, room.now));
    const MapUpdate next = room.add(poseFrom({1.0, 0, 0.9}, 0, 0, 0));
    ASSERT_TRUE(next.keyScan);
    EXPECT_EQ(next.localisation.trust, ScanTrust::Certain);
    EXPECT_FALSE(next.links) << "with what was rejected";
    const LiveKeyScan begun = room.mapper.map()->scans.back();
    EXPECT_EQ(begun.part, begun.id);
    EXPECT_EQ(begun.scan->points.size(), next.keyScan->scan->points.size()) << "cut";
    // Decided on, the parts are found anew.
    ASSERT_TRUE(room.mapper.reject(other.keyScan->id, room.now));
    EXPECT_EQ(room.mapper.map()->scans.back().part, begun.id);
}

TEST(LiveMapperParts, UntilItIsSolvedAPartIsWhereItLies) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto question = room.explore(8);
    ASSERT_TRUE(question);
    room.answer(*question, true);
    EXPECT_NE(room.mapper.map()->scans.back().part, 0U) << "its scans stand aside yet";
    const MapUpdate meanwhile = room.add(room.seen(poseFrom({-1.5, -1.2, 0.9}, 0, 0, degrees(240))));
    EXPECT_EQ(meanwhile.localisation.trust, ScanTrust::Certain);
    ASSERT_TRUE(room.solveAll());
    EXPECT_EQ(room.mapper.map()->scans.back().part, 0U);
}

TEST(LiveMapperParts, AStationThatStartsAgainKnowsTheParts) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const auto question = room.explore(8);
    ASSERT_TRUE(question);
    LiveMapper apart = room.log.readAgain();
    EXPECT_EQ(apart.map()->scans.front().part, 0U);
    EXPECT_EQ(apart.map()->scans.back().part, room.second.front().first);
    room.answer(*question, true);
    LiveMapper together = room.log.readAgain();
    EXPECT_EQ(together.map()->scans.back().part, 0U);
    EXPECT_TRUE(together.problem()) << "a log that ends before the poses is solved";
}

TEST(LiveMapperParts, ByHandAScanIsShownItsPlaceInTheOtherPart) {
    TwoRobotsInARoom room;
    room.mapper.beginPart("second");
    const Pose here = poseFrom({1.0, 0.8, 0.9}, 0, 0, degrees(200));
    const MapUpdate update = room.add(room.seen(here));
    ASSERT_TRUE(update.keyScan);
    const Pose roomInMap =
        room.mapper.map()->scans.front().pose.scanInMap * poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse();
    const auto question = room.mapper.propose(
        update.keyScan->id, roomInMap * here * poseFrom({0.3, 0.2, 0}, 0, 0, degrees(5)), room.now);
    ASSERT_TRUE(question) << question.error().text;
    room.answer(*question, true);
    room.second.emplace_back(update.keyScan->id, here);
    ASSERT_TRUE(room.solveAll());
    EXPECT_LT(room.worst(), 0.03);
}

}  // namespace
}  // namespace leitstand::test
