#include "core/mapping/relaxation/relaxation.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/graph/scan_graph.h"
#include "core/mapping/relaxation/closed_map.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Where the scanner is on a circle of 6 m in the furnished room.
Pose onCircle(int place) {
    const double angle = 0.4 * place;
    return poseFrom({-std::cos(angle), -std::sin(angle), 0.9}, 0, 0, angle - M_PI / 2);
}

/// Scans hang together over so little way that a circle of 6 m meets itself.
LiveSettings closing() {
    LiveSettings settings;
    settings.loops.sameAge = 2.0;
    settings.loops.about = 1.5;
    settings.loops.reach = 1.5;
    settings.loops.apart = 0.3;
    return settings;
}

/// The map of a room in which a robot drove in a circle, and the links of its scans.
struct Circle {
    explicit Circle(int scans) {
        MappedRoom room(closing());
        for (int place = 0; place < scans; ++place) {
            const MapUpdate update = room.add(onCircle(place));
            if (update.links)
                links.insert(links.end(), update.links->links.begin(), update.links->links.end());
            truth.push_back(onCircle(0).inverse() * onCircle(place));
        }
        map = *room.mapper.map();
    }
    /// The farthest scan from where it is in truth [m].
    [[nodiscard]] double error(const std::vector<GraphNode>& nodes) const {
        double most = 0.0;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            most = std::max(most, distanceBetween(nodes[i].pose, truth[i]));
        return most;
    }
    LiveMap map;
    std::vector<Link> links;
    std::vector<Pose> truth;
};

TEST(Relaxation, ScansThatWereMovedComeBackToWhereSurfacesWantThem) {
    Circle circle(6);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> off(-0.06, 0.06);
    for (std::size_t i = 1; i < circle.map.scans.size(); ++i) {
        Pose& pose = circle.map.scans[i].pose.scanInMap;
        pose = pose * poseFrom({off(random), off(random), 0.3 * off(random)}, 0, 0, 0.3 * off(random));
    }
    RelaxationSettings how;
    how.threads = 1;
    const Relaxation relaxed = relax(circle.map, circle.links, closing(), how);
    EXPECT_TRUE(relaxed.settled) << relaxed.rounds;
    EXPECT_EQ(relaxed.matched, 6U);
    EXPECT_LT(circle.error(relaxed.nodes), 0.006);
    EXPECT_GT(relaxed.largest, 0.03);
    EXPECT_LT(relaxed.rmsAfter, relaxed.rmsBefore);
    EXPECT_TRUE(relaxed.nodes.front().pose.isApprox(circle.map.scans.front().pose.scanInMap))
        << "the first one stays";
    how.threads = 2;
    const Relaxation again = relax(circle.map, circle.links, closing(), how);
    for (std::size_t i = 0; i < again.nodes.size(); ++i)
        EXPECT_EQ(again.nodes[i].pose.matrix(), relaxed.nodes[i].pose.matrix()) << "whatever the threads";
}

TEST(Relaxation, ScansAtTwoPlacesWithMoreThanFourEachStillHangTogether) {
    MappedRoom room;
    ScanGraph graph;
    std::vector<Link> links;
    for (int i = 0; i < 12; ++i) {  // turns about itself, goes on by 0.8 m, turns again
        const MapUpdate update =
            room.add(poseFrom({i < 6 ? -0.4 : 0.4, 0, 0.9}, 0, 0, degrees(12.0 * (i % 6))));
        if (update.links) links.insert(links.end(), update.links->links.begin(), update.links->links.end());
    }
    const LiveMapPtr map = room.mapper.map();
    ASSERT_THAT(map->scans, SizeIs(12));
    const Relaxation relaxed = relax(*map, links, {});
    EXPECT_THAT(relaxed.replaced, testing::Not(IsEmpty()));
    const std::set<std::uint64_t> replaced(relaxed.replaced.begin(), relaxed.replaced.end());
    for (const Link& link : links) {
        // Where surfaces hold all directions, odometry says nothing.
        if (link.kind == LinkKind::Match && !replaced.contains(link.id)) graph.add(link);
    }
    for (const Link& link : relaxed.matches) graph.add(link);
    EXPECT_THAT(graph.within(map->scans.front().id, 1'000.0), SizeIs(12));
}

TEST(Relaxation, OfScansThatAreSetAsideNothingIsAskedAndUncertainOnesAreNotBuiltOn) {
    Circle circle(5);
    circle.map.scans[2].pose.trust = ScanTrust::SetAside;
    circle.map.scans[3].pose.trust = ScanTrust::Uncertain;
    circle.map.scans[3].pose.scanInMap = circle.truth[3] * poseFrom({0.2, 0, 0}, 0, 0, 0);
    const Relaxation relaxed = relax(circle.map, circle.links, closing());
    EXPECT_THAT(relaxed.nodes, SizeIs(4));
    EXPECT_EQ(relaxed.matched, 3U);
    EXPECT_TRUE(std::none_of(relaxed.matches.begin(), relaxed.matches.end(), [](const Link& link) {
        return link.from == 3 || link.to == 3 || link.from == 4 || link.to == 4;
    }));
}

TEST(Relaxation, OfAMapWithoutScansThereIsNothing) {
    const Relaxation relaxed = relax({}, {}, closing());
    EXPECT_THAT(relaxed.nodes, IsEmpty());
    EXPECT_TRUE(relaxed.settled);
}

TEST(Relaxation, IsCancelledWithAllWhereItWas) {
    const Circle circle(4);
    std::stop_source stop;
    stop.request_stop();
    const Relaxation relaxed = relax(circle.map, circle.links, closing(), {}, {{}, stop.get_token()});
    EXPECT_EQ(relaxed.rounds, 0);
    EXPECT_EQ(relaxed.nodes[2].pose.matrix(), circle.map.scans[2].pose.scanInMap.matrix());
}

/// A row of scans on the circle, each registered to the one before with an error of @p turned [rad].
Map chain(int scans, double turned) {
    Map map;
    Pose pose = Pose::Identity();
    for (int place = 0; place < scans; ++place) {
        MapScan scan;
        scan.scan = scanAt(onCircle(place), static_cast<unsigned>(place + 1)).scan;
        if (place > 0)
            pose = pose * onCircle(place - 1).inverse() * onCircle(place) * poseFrom({0, 0, 0}, 0, 0, turned);
        scan.poseInMap = pose;
        scan.registered = place > 0;
        map.scans.push_back(std::move(scan));
    }
    return map;
}

double errorOf(const std::vector<Pose>& poses) {
    double most = 0.0;
    for (std::size_t i = 0; i < poses.size(); ++i)
        most =
            std::max(most, distanceBetween(poses[i], onCircle(0).inverse() * onCircle(static_cast<int>(i))));
    return most;
}

TEST(ClosedMaps, AreRightWhereTheRowWasOff) {
    const Map map = chain(20, degrees(0.6));
    std::vector<Pose> before;
    for (const MapScan& scan : map.scans) before.push_back(scan.poseInMap);
    ASSERT_GT(errorOf(before), 0.15);
    const auto closed = closeLoops(map, {}, closing());
    ASSERT_TRUE(closed) << closed.error().text;
    ASSERT_THAT(closed->poses, SizeIs(20));
    EXPECT_GE(closed->closed.size() + closed->unsure.size(), 1U) << "the way came back";
    EXPECT_LT(errorOf(closed->poses), 0.01);
    EXPECT_TRUE(closed->relaxation.settled);
}

TEST(ClosedMaps, FollowWhatIsGivenByHandAndCloseNothingThatIsRefused) {
    const Map map = chain(20, degrees(0.5));
    const Pose truth = onCircle(1).inverse() * onCircle(17);
    const std::vector<GivenLink> same = {{1, 17, truth * poseFrom({0.05, -0.05, 0}, 0, 0, degrees(1))}};
    const auto closed = closeLoops(map, same, closing());
    ASSERT_TRUE(closed);
    EXPECT_LT(errorOf(closed->poses), 0.01) << "what is given is rough, matches are not";
    // Each in its own time, beside what the mapper numbers itself.
    const std::vector<GivenLink> several = {{0, 3, std::nullopt},
                                            {1, 17, truth},
                                            {3, 18, onCircle(3).inverse() * onCircle(18)},
                                            {5, 2, onCircle(5).inverse() * onCircle(2)}};
    const auto all = closeLoops(map, several, closing());
    ASSERT_TRUE(all);
    EXPECT_LT(errorOf(all->poses), 0.01);
    EXPECT_EQ(all->unused, 0U);
    std::vector<GivenLink> refused;
    for (std::size_t from = 0; from < 8; ++from) {
        for (std::size_t to = from + 11; to < 20; ++to) refused.push_back({from, to, std::nullopt});
    }
    const auto open = closeLoops(map, refused, closing());
    ASSERT_TRUE(open);
    EXPECT_THAT(open->closed, IsEmpty());
    EXPECT_THAT(open->unsure, IsEmpty());
}

TEST(ClosedMaps, CancelledThereIsNoneWhereverItWas) {
    const Map map = chain(8, degrees(0.5));
    for (const double until : {0.1, 0.55}) {
        std::stop_source stop;
        const Progress progress{[&](double fraction) {
                                    if (fraction > until) stop.request_stop();
                                },
                                stop.get_token()};
        const auto closed = closeLoops(map, {}, closing(), {}, progress);
        ASSERT_TRUE(closed);
        EXPECT_THAT(closed->poses, IsEmpty()) << until;
    }
}

TEST(ClosedMaps, NameWhatIsWrongWithWhatIsGiven) {
    const Map map = chain(2, 0.0);
    const std::vector<GivenLink> beyond = {{0, 2, std::nullopt}}, itself = {{1, 1, std::nullopt}};
    EXPECT_THAT(closeLoops(map, beyond).error().text, HasSubstr("the 2 scans, from 0"));
    EXPECT_THAT(closeLoops(map, itself).error().text, HasSubstr("scan 1"));
    EXPECT_THAT(closeLoops({}, {})->poses, IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
