#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/live/live_mapper.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

/// Scans hang together over so little way that a circle of 6 m meets itself.
LiveSettings closing() {
    LiveSettings settings;
    settings.loops.on = true;
    settings.loops.sameAge = 2.0;
    settings.loops.about = 1.5;
    settings.loops.reach = 1.5;
    settings.loops.apart = 0.3;
    settings.loops.noticed = settings.loops.noticedAngle = 1e-5;
    return settings;
}

/// A room in which the robot drove in a circle, until the map met itself.
struct ClosedRoom : MappedRoom {
    explicit ClosedRoom(const LiveSettings& settings = closing()) : MappedRoom(settings) {
        for (; !loop && scans < 20; ++scans) {
            last = addAt(scans);
            loop = last.loop;
        }
    }
    MapUpdate addAt(int place) {
        const double angle = 0.4 * place;
        return add(poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2));
    }
    /// Takes the loop back, or closes it again.
    void follow(bool closed) {
        ScanLinksSample now = *loop;
        for (Link& link : now.links) link.active = closed;
        mapper.followLoops(now.links);
    }

    std::optional<ScanLinksSample> loop;
    MapUpdate last;
    int scans = 0;
};

/// Bit for bit.
bool same(const std::vector<GraphNode>& a, const std::vector<GraphNode>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const GraphNode& one, const GraphNode& other) {
                          return one.id == other.id && one.pose.matrix() == other.pose.matrix();
                      });
}

TEST(LiveMapperLoops, EachScanSaysWhatItWasRegisteredAgainst) {
    MappedRoom room(closing());
    EXPECT_FALSE(room.add(poseFrom({-1.0, 0, 0.9}, 0, 0, 0)).links) << "there is nothing yet";
    const MapUpdate update = room.add(poseFrom({-0.6, 0, 0.9}, 0, 0, 0));
    ASSERT_TRUE(update.links);
    EXPECT_EQ(update.links->station, "station");
    ASSERT_THAT(update.links->links, SizeIs(2));
    EXPECT_EQ(update.links->links[0].kind, LinkKind::Odometry);
    EXPECT_EQ(update.links->links[1].kind, LinkKind::Match);
    for (const Link& link : update.links->links) {
        EXPECT_EQ(link.from, 1U);
        EXPECT_EQ(link.to, 2U);
        EXPECT_NEAR(link.pose.translation().x(), 0.4, 0.01);
    }
    EXPECT_LT(update.links->links[0].information(0, 0), 0.1 * update.links->links[1].information(0, 0))
        << "walls hold all directions: odometry has hardly a say";
    EXPECT_FALSE(room.mapper.problem()) << "nothing met itself";
}

TEST(LiveMapperLoops, OfARobotThatWasPutSomewhereOdometryHoldsNothing) {
    MappedRoom room(closing());
    (void)room.add(poseFrom({-1.0, 0, 0.9}, 0, 0, 0));
    (void)room.add(poseFrom({-0.6, 0, 0.9}, 0, 0, 0));
    const Pose there = poseFrom({0.6, 0.5, 0}, 0, 0, degrees(60));
    room.mapper.place("kurt3d", poseFrom({-1.0, 0, 0.9}, 0, 0, 0).inverse() * there);
    // Carried: its odometry stands where it was.
    const Pose sensor = there * poseFrom({0, 0, 0.9}, 0, 0, 0);
    const MapUpdate update = room.add(sensor, sensor.inverse() * poseFrom({-0.6, 0, 0.9}, 0, 0, 0));
    ASSERT_EQ(update.localisation.trust, ScanTrust::Certain);
    ASSERT_TRUE(update.links);
    for (const Link& link : update.links->links) EXPECT_EQ(link.kind, LinkKind::Match);
}

TEST(LiveMapperLoops, WhereTheMapMeetsItselfScansMoveTogether) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop) << "after " << room.scans << " scans";
    EXPECT_GE(room.loop->links.size(), 2U) << "two places that agree";
    for (const Link& link : room.loop->links) {
        EXPECT_EQ(link.kind, LinkKind::Loop);
        EXPECT_LT(link.from, link.to);
        EXPECT_TRUE(link.active);
    }
    const auto moved = room.solveAll();
    ASSERT_TRUE(moved);
    EXPECT_EQ(moved->cause, ScanPosesSample::Cause::LoopClosure);
    EXPECT_TRUE(std::none_of(moved->poses.begin(), moved->poses.end(), [](const ScanPose& pose) {
        return pose.scan == 1;
    })) << "the first scan is the map's frame";
    EXPECT_TRUE(alike(room.poses(), room.log.poses()));
    EXPECT_FALSE(room.mapper.problem()) << "all is solved";
}

TEST(LiveMapperLoops, TakenBackScansStandAsIfItHadNeverClosed) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    auto never = room.mapper.problem();
    ASSERT_TRUE(never);
    const MapSolution closed = solve(*never);
    std::erase_if(never->graph.links, [](const Link& link) { return link.kind == LinkKind::Loop; });
    const MapSolution open = solve(*never);
    EXPECT_FALSE(same(open.nodes, closed.nodes));
    (void)room.mapper.settle(closed, room.now);
    room.follow(false);
    const auto problem = room.mapper.problem();
    ASSERT_TRUE(problem);
    EXPECT_TRUE(same(solve(*problem).nodes, open.nodes)) << "bit for bit, whatever was solved before";
    (void)room.mapper.settle(solve(*problem), room.now);
    room.follow(true);
    const auto again = room.mapper.problem();
    ASSERT_TRUE(again);
    EXPECT_TRUE(same(solve(*again).nodes, closed.nodes)) << "and closed again the same";
}

TEST(LiveMapperLoops, WhatWasTakenBackDoesNotCloseThereAgain) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    (void)room.solveAll();
    room.follow(false);
    (void)room.solveAll();
    for (int i = 0; i < 3; ++i) EXPECT_FALSE(room.addAt(room.scans++).loop) << i;
}

TEST(LiveMapperLoops, ALogThatEndsBeforeThePosesIsSolvedWhenTheStationStartsAgain) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    LiveMapper again = room.log.readAgain(closing());
    const auto problem = again.problem();
    ASSERT_TRUE(problem);
    const auto live = room.mapper.problem();
    ASSERT_TRUE(live);
    EXPECT_TRUE(same(solve(*problem).nodes, solve(*live).nodes));
    EXPECT_TRUE(again.settle(solve(*problem), room.now).poses);
}

TEST(LiveMapperLoops, AStationThatStartsAgainGoesOnWithTheSameLinks) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    (void)room.solveAll();
    const std::uint64_t newest = room.loop->links.back().id;
    LiveMapper again = room.log.readAgain(closing());
    const auto problem = again.problem();
    ASSERT_TRUE(problem) << "it is looked at anew";
    EXPECT_FALSE(again.settle(solve(*problem), room.now).poses) << "all stands where the log has it";
    const double angle = 0.4 * room.scans;
    const MapUpdate next = again.add(
        scanAt(poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2), 99), room.now);
    ASSERT_TRUE(next.links);
    EXPECT_GT(next.links->links.front().id, newest) << "ids are not given twice";
    EXPECT_EQ(next.localisation.trust, ScanTrust::Certain);
}

TEST(LiveMapperLoops, WhatEntersWhileItIsSolvedGoesAlong) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    const auto problem = room.mapper.problem();
    ASSERT_TRUE(problem);
    const MapUpdate late = room.addAt(room.scans);
    ASSERT_TRUE(late.keyScan);
    EXPECT_FALSE(room.mapper.problem()) << "somebody is at it";
    room.mapper.leaveUnsettled();
    EXPECT_TRUE(room.mapper.problem()) << "who was at it has given up";
    const auto before = room.poses();
    MapSolution far = solve(*problem);
    for (GraphNode& node : far.nodes) {
        if (node.id > 1) node.pose = poseFrom({0, 0, 0}, 0, 0, degrees(1)) * node.pose;
    }
    ASSERT_TRUE(room.mapper.settle(far, room.now).poses);
    const auto after = room.poses();
    const std::size_t newest = after.size() - 1;
    const auto matched = static_cast<std::size_t>(late.keyScan->matched - 1);
    EXPECT_TRUE((before[matched].scanInMap.inverse() * before[newest].scanInMap)
                    .isApprox(after[matched].scanInMap.inverse() * after[newest].scanInMap, 1e-9));
    const auto fix = room.mapper.fix("kurt3d");
    ASSERT_TRUE(fix);
    EXPECT_TRUE(fix->baseInMap.isApprox(after[newest].scanInMap, 1e-9)) << "the robot, too";
}

TEST(LiveMapperLoops, DecisionsThatCameInBetweenAreNotOverrun) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    const auto problem = room.mapper.problem();
    ASSERT_TRUE(problem);
    ASSERT_TRUE(room.mapper.reject(2, room.now).ok());
    const Settled settled = room.mapper.settle(solve(*problem), room.now);
    EXPECT_FALSE(settled.poses);
    const auto remade = room.mapper.problem();
    ASSERT_TRUE(remade);
    EXPECT_EQ(remade->graph.nodes.size(), problem->graph.nodes.size() - 1)
        << "what is set aside holds nothing";
}

TEST(LiveMapperLoops, ALoopThatTheOthersSpeakAgainstIsTakenOutAndTold) {
    ClosedRoom room;
    ASSERT_TRUE(room.loop);
    Link wrong = room.loop->links.front();
    std::uint64_t largest = 0;
    for (const Link& link : room.loop->links) largest = std::max(largest, link.id);
    wrong.id = largest + 1;
    wrong.pose.translation() += Eigen::Vector3d(1.0, 0.5, 0.0);
    room.mapper.restore(ScanLinksSample{room.now, "station", {wrong}});
    const auto problem = room.mapper.problem();
    ASSERT_TRUE(problem);
    const MapSolution solution = solve(*problem);
    EXPECT_THAT(solution.contradicted, ElementsAre(wrong.id));
    const Settled settled = room.mapper.settle(solution, room.now);
    ASSERT_TRUE(settled.links);
    ASSERT_THAT(settled.links->links, SizeIs(1));
    EXPECT_EQ(settled.links->links.front().id, wrong.id);
    EXPECT_FALSE(settled.links->links.front().active);
    const auto truth = [&](std::size_t i) {
        const double angle = 0.4 * static_cast<double>(i);
        return poseFrom({-1.0, 0, 0.9}, 0, 0, -M_PI / 2).inverse() *
               poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2);
    };
    const auto poses = room.poses();
    for (std::size_t i = 0; i < poses.size(); ++i)
        EXPECT_LT(distanceBetween(poses[i].scanInMap, truth(i)), 0.03) << i;
}

TEST(LiveMapperLoops, WhereTheMapErredMoreThanExpectedNothingMovesAndItIsAskedOnce) {
    LiveSettings settings = closing();
    settings.loops.drift = settings.loops.driftAtLeast = 1e-6;
    ClosedRoom room(settings);
    ASSERT_TRUE(room.loop) << "the question";
    for (const Link& link : room.loop->links) EXPECT_FALSE(link.active);
    EXPECT_FALSE(room.mapper.problem()) << "unanswered, nothing moves";
    for (int i = 0; i < 2; ++i) EXPECT_FALSE(room.addAt(room.scans++).loop) << "asked once";
    ScanLinksSample yes = *room.loop;
    for (Link& link : yes.links) {
        link.kind = LinkKind::Operator;
        link.active = true;
    }
    room.mapper.restore(yes);
    EXPECT_TRUE(room.solveAll()) << "the operator's answer";
}

TEST(LiveMapperLoops, WhereTheOperatorHadAScanRegisteredAgainItStaysWhenTheMapIsSolved) {
    MappedRoom room(closing());
    room.drive(3);
    const Pose slipped = poseFrom({0.9, -0.7, 0}, 0, 0, degrees(25));
    const Pose there = room.last * poseFrom({0.4, 0, 0}, 0, 0, 0);
    const MapUpdate doubted = room.add(there, slipped);
    ASSERT_TRUE(doubted.keyScan);
    ASSERT_EQ(doubted.localisation.trust, ScanTrust::Uncertain);
    const std::uint64_t id = doubted.keyScan->id;
    RetrySettings settings;
    settings.guessInMap = poseFrom({-1.4, 0, 0.9}, 0, 0, 0).inverse() * there;
    const auto decision = room.mapper.retry(id, settings, room.now);
    ASSERT_TRUE(decision.ok());
    ASSERT_EQ(decision->poses.front().trust, ScanTrust::Certain);
    const auto links = room.mapper.takeLinks();
    ASSERT_TRUE(links);
    EXPECT_FALSE(room.mapper.takeLinks()) << "once";
    Link loop = links->links.back();  // one that agrees: for solving
    loop.id = 500;
    loop.kind = LinkKind::Operator;
    loop.from = 1;
    loop.to = 2;
    loop.pose = room.poses()[0].scanInMap.inverse() * room.poses()[1].scanInMap;
    room.mapper.restore(ScanLinksSample{room.now, "station", {loop}});
    const auto problem = room.mapper.problem();
    ASSERT_TRUE(problem);
    EXPECT_LT(distanceBetween(solve(*problem).nodes.back().pose, decision->poses.front().scanInMap), 0.02);
    // Taken back it is where odometry had it.
    room.mapper.follow(std::vector<ScanPose>{room.poses()[0], room.poses()[1], room.poses()[2],
                                             doubted.poses->poses.front()});
    room.mapper.restore(ScanLinksSample{room.now, "station", {loop}});
    const auto back = room.mapper.problem();
    ASSERT_TRUE(back);
    EXPECT_LT(distanceBetween(solve(*back).nodes.back().pose, doubted.poses->poses.front().scanInMap), 0.02);
}

/// A room of which the second half of the way stands 5 m and 30 degrees off, and no place is within reach.
struct TornRoom : MappedRoom {
    static LiveSettings settings(double drift) {
        LiveSettings settings = closing();
        settings.loops.reach = 0.5;
        settings.loops.seekEvery = 0.3;
        settings.loops.drift = settings.loops.openDrift = drift;
        return settings;
    }
    explicit TornRoom(double drift) : MappedRoom(settings(drift)) {
        for (; scans < 9; ++scans) (void)addAt(scans);
        std::vector<ScanPose> poses = this->poses();
        for (ScanPose& one : poses) {
            if (one.scan > 5) one.scanInMap = torn * one.scanInMap;
        }
        mapper.follow(poses);
        for (; scans < 16; ++scans) (void)addAt(scans);
        (void)mapper.sought();  // of where nothing was before
    }
    MapUpdate addAt(int place) {
        const double angle = 0.4 * place;
        return add(poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2));
    }
    /// The next scan, and where the first part of the map has it.
    std::optional<ScanLinksSample> recogniseNext() {
        const MapUpdate update = addAt(scans++);
        if (update.loop) return update.loop;
        const auto sought = mapper.sought();
        if (!sought) return std::nullopt;
        ++asked;
        return mapper.recognised(*sought, torn.inverse() * update.scanInMap, now);
    }

    const Pose torn = poseFrom({4.0, 3.0, 0}, 0, 0, degrees(30));
    int scans = 0, asked = 0;
};

TEST(LiveMapperLoops, APlaceThatIsRecognisedFarOffClosesWhereThreeAgreeAndIsAskedAbout) {
    TornRoom room(0.25);
    std::optional<ScanLinksSample> loop;
    int tries = 0;
    for (; !loop && tries < 6; ++tries) loop = room.recogniseNext();
    ASSERT_TRUE(loop);
    EXPECT_GE(tries, 3) << "one or two may look alike by chance";
    EXPECT_GE(room.asked, 1);
    ASSERT_GE(loop->links.size(), 3U);
    for (Link& link : loop->links) {
        EXPECT_EQ(link.kind, LinkKind::Loop);
        EXPECT_FALSE(link.active) << "that far off the operator is asked";
        link.active = true;
    }
    EXPECT_FALSE(room.mapper.problem());
    room.mapper.followLoops(loop->links);  // "it is the same place"
    ASSERT_TRUE(room.solveAll());
    const std::vector<ScanPose> poses = room.poses();
    const Pose again = poses.front().scanInMap.inverse() * poses.at(16).scanInMap;
    const double angle = 0.4 * 16;
    const Pose first = poseFrom({-1.0, 0, 0.9}, 0, 0, -M_PI / 2);
    const Pose expected =
        first.inverse() * poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2);
    EXPECT_LT(distanceBetween(again, expected), 0.05);
}

TEST(LiveMapperLoops, WhatIsFartherOffThanTheMapCanHaveErredIsNoLoop) {
    TornRoom room(0.05);
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(room.recogniseNext()) << i;
    EXPECT_GE(room.asked, 3);
}

TEST(LiveMapperLoops, NothingIsSoughtWhereTheMapCannotHaveErredByMoreThanIsLookedForAnyway) {
    TornRoom room(0.005);
    for (int i = 0; i < 4; ++i) EXPECT_FALSE(room.recogniseNext()) << i;
    EXPECT_EQ(room.asked, 0);
}

TEST(LiveMapperLoops, WhereTheMapMovedMeanwhileAPlaceThatWasFoundSaysNothing) {
    for (const bool moves : {false, true}) {
        TornRoom room(0.25);
        const MapUpdate first = room.addAt(room.scans++);
        const auto sought = room.mapper.sought();
        ASSERT_TRUE(sought);
        ASSERT_FALSE(room.recogniseNext());
        ASSERT_FALSE(room.addAt(room.scans++).loop) << "by now two agree";
        if (moves) {
            std::vector<ScanPose> poses = room.poses();
            poses.front().scanInMap.translation().x() += 0.01;
            room.mapper.follow(poses);
        }
        const auto loop = room.mapper.recognised(*sought, room.torn.inverse() * first.scanInMap, room.now);
        EXPECT_EQ(loop.has_value(), !moves);
    }
}

TEST(LiveMapperLoops, TheOperatorShowsRoughlyWhereAScanMeetsAnOlderPart) {
    TornRoom room(0.005);
    const MapUpdate update = room.addAt(room.scans++);
    const Pose there = room.torn.inverse() * update.scanInMap;
    const std::uint64_t id = update.keyScan->id;
    const auto text = [](const Result<ScanLinksSample>& result) {
        return result.ok() ? std::string("it fits") : result.error().text;
    };
    EXPECT_THAT(text(room.mapper.propose(99, there, room.now)), HasSubstr("expected one that counts"));
    EXPECT_THAT(text(room.mapper.propose(id, there * poseFrom({9, 0, 0}, 0, 0, 0), room.now)),
                HasSubstr("no older part of the map is within 0.5 m"));
    EXPECT_THAT(text(room.mapper.propose(id, there * poseFrom({0, 0, 0}, 0, 0, degrees(90)), room.now)),
                HasSubstr("does not fit there"));
    const Pose drawn = there * poseFrom({0.2, -0.15, 0}, 0, 0, degrees(7));
    const auto shown = room.mapper.propose(id, drawn, room.now);
    ASSERT_TRUE(shown.ok()) << shown.error().text;
    ASSERT_THAT(shown->links, SizeIs(1));
    EXPECT_FALSE(shown->links.front().active) << "a question";
    const LiveMapPtr map = room.mapper.map();
    const auto from = std::find_if(map->scans.begin(), map->scans.end(),
                                   [&](const auto& one) { return one.id == shown->links.front().from; });
    ASSERT_NE(from, map->scans.end());
    EXPECT_LT(distanceBetween(from->pose.scanInMap * shown->links.front().pose, there), 0.03) << "it snaps";
}

TEST(LiveMapperLoops, NoPlaceIsSoughtWhileAllHangsTogetherOrWhenToldNotTo) {
    MappedRoom room(closing());
    for (int i = 0; i < 4; ++i) (void)room.add(poseFrom({-0.6 + 0.4 * i, 0, 0.9}, 0, 0, 0));
    EXPECT_FALSE(room.mapper.sought()) << "1.2 m of way";
    LiveSettings never = TornRoom::settings(0.25);
    never.loops.seekEvery = 0.0;
    MappedRoom other(never);
    for (int i = 0; i < 14; ++i) {
        const double angle = 0.4 * i;
        (void)other.add(poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2));
    }
    EXPECT_FALSE(other.mapper.sought());
}

}  // namespace
}  // namespace leitstand::test
