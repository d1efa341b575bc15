#include "core/mapping/relocalisation/place_recognition.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/live/loops/loop_closer.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

/// Places that were looked for in a map whose newer part is far off.
struct Recognitions {
    int revisits = 0, found = 0, wrong = 0;  ///< where the robot was before, long ago: by one scan
    int firsts = 0, mistaken = 0;            ///< where it was never before: by one scan
    int asked = 0, askedWrongly = 0;         ///< questions that came of it, once others agreed
    std::vector<double> seconds;
};

constexpr double Lately = 45.0;  ///< so much of the way before a scan hangs together with it [m]

bool isRight(const Pose& found, const Pose& truth) {
    return distanceBetween(found, truth) < 0.2 && angleBetween(found, truth) < degrees(2);
}

/// What the operator is asked when the scan @p newest of @p scans, whose ways are @p way, was found at
/// @p found in @p bent, whose newer part @p turned has moved: whether that is right. Empty: nothing, as the
/// scans that follow do not agree.
std::optional<bool> question(const std::vector<LiveKeyScan>& scans, const std::vector<double>& way,
                             std::size_t newest, const Pose& turned, const Pose& found, LiveMap bent) {
    LoopSettings settings;
    settings.sameAge = Lately;
    MapGraph graph(settings, {});
    const PlaceFinder places(settings, {}, {}, graph);
    LoopCloser closer(settings, graph, places);
    const auto enters = [&](std::size_t i) {
        if (i == 0) return;
        const bool lately = way[newest] - way[i] <= Lately;
        Link link = linkBetween(scans[i - 1], scans[i], lately ? LinkKind::Odometry : LinkKind::Match);
        link.id = i;
        graph.restore({&link, 1});
    };
    for (std::size_t i = 0; i <= newest; ++i) enters(i);
    std::vector<Link> links = closer.closeFar(bent.scans.back(), found, bent);
    for (std::size_t i = newest + 1; links.empty() && i < scans.size(); ++i) {
        if (way[i] - way[newest] > settings.pendingWithin) break;
        enters(i);
        bent.scans.push_back(scans[i]);
        bent.scans.back().pose.scanInMap = turned * scans[i].pose.scanInMap;
        links = closer.close(bent.scans.back(), bent);
    }
    if (links.empty()) return std::nullopt;
    const auto poseOf = [&](std::uint64_t id) {
        return std::find_if(scans.begin(), scans.end(), [id](const auto& one) { return one.id == id; })
            ->pose.scanInMap;
    };
    return std::all_of(links.begin(), links.end(), [&](const Link& link) {
        return isRight(poseOf(link.from) * link.pose, poseOf(link.to));
    });
}

/// Drives a figure of eight through a building. Then each scan in turn is taken as the newest one of a map
/// whose last part is 5 m and 45 degrees off, as by a stretch on which odometry alone held.
void recogniseIn(const BuildingSettings& settings, std::uint64_t seed, double every, Recognitions& sum) {
    const Building building = std::move(generateBuilding(settings, seed)).value();
    ScriptSettings script;
    script.seed = seed;
    LiveSettings mapping;
    mapping.loops.on = false;
    ScriptedDrive made = scriptedDrive(building.arena, DrivePath(eightRoute(building.ways, 4)), script);
    const MappedDrive drive = mapped(made.drive, std::move(made.scans), mapping);
    const auto& scans = drive.map->scans;
    const auto positionOf = [&](std::size_t i) {
        return Eigen::Vector3d(made.drive.baseInArena(scans[i].scan->end).translation());
    };
    std::vector<double> way = {0.0};
    for (std::size_t i = 1; i < scans.size(); ++i)
        way.push_back(way.back() + (positionOf(i) - positionOf(i - 1)).norm());
    double last = 0.0;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        if (way[i] < Lately + 10.0 || way[i] - last < every) continue;
        double nearest = 1e9;
        for (std::size_t j = 0; way[i] - way[j] > Lately; ++j)
            nearest = std::min(nearest, (positionOf(i) - positionOf(j)).norm());
        const bool revisit = nearest < 1.0;
        if (!revisit && nearest < 6.0) continue;
        last = way[i];
        const Pose here = scans[i].pose.scanInMap;
        const Pose turned = Pose(Eigen::Translation3d(here.translation() + Eigen::Vector3d(4.0, -3.0, 0.0)) *
                                 Eigen::AngleAxisd(degrees(45), Eigen::Vector3d::UnitZ()) *
                                 Eigen::Translation3d(-here.translation()));
        const auto bent = std::make_shared<LiveMap>();
        SoughtPlace sought;
        sought.scan = scans[i].id;
        for (std::size_t j = 0; j <= i; ++j) {
            LiveKeyScan scan = scans[j];
            if (way[i] - way[j] <= Lately) {
                scan.pose.scanInMap = turned * scan.pose.scanInMap;
                sought.lately.emplace(scan.id, way[i] - way[j]);
            }
            bent->scans.push_back(std::move(scan));
        }
        sought.map = bent;
        const double began = processorTime();
        const auto found = recognise(sought, {});
        sum.seconds.push_back(processorTime() - began);
        ++(revisit ? sum.revisits : sum.firsts);
        if (!found) continue;
        const bool right = isRight(*found, here);
        const auto asked = question(scans, way, i, turned, *found, *bent);
        if (asked) ++(*asked ? sum.asked : sum.askedWrongly);
        if (!right)
            std::printf("building %llu: scan %zu is taken for one %.2f m and %.1f degrees off; %s\n",
                        static_cast<unsigned long long>(seed), i, distanceBetween(*found, here),
                        inDegrees(angleBetween(*found, here)),
                        !asked   ? "nothing is asked"
                        : *asked ? "asked about the right one"
                                 : "asked");
        if (!revisit) ++sum.mistaken;
        if (revisit) ++(right ? sum.found : sum.wrong);
    }
}

void print(const char* name, const Recognitions& sum) {
    using leitstand::test::quantile;
    std::printf(
        "%s: of %d places that were seen before %d recognised, %d taken for another; of %d new ones %d "
        "mistaken; asked %d rightly, %d wrongly; %.2f s (median), %.2f s (95 %%) of a core\n",
        name, sum.revisits, sum.found, sum.wrong, sum.firsts, sum.mistaken, sum.asked, sum.askedWrongly,
        quantile(sum.seconds, 0.5), quantile(sum.seconds, 0.95));
}

TEST(PlaceRecognitionLong, PlacesAreRecognisedWhereTheMapIsFiveMetresOff) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    Recognitions sum;
    for (int i = 0; i < measuredBuildings(10); ++i) {
        recogniseIn(settings, firstSeed(601) + static_cast<std::uint64_t>(i), 2.0, sum);
        print("so far", sum);
    }
    print("place recognition", sum);
    EXPECT_GT(sum.revisits, 0);
    EXPECT_GE(sum.found, 0.9 * sum.revisits);
    EXPECT_GE(sum.asked, 0.8 * sum.revisits);
    EXPECT_LE(sum.wrong, 0.01 * sum.revisits);
    EXPECT_EQ(sum.askedWrongly, 0);
}

TEST(PlaceRecognitionLong, AmongTwins) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.twins = true;
    Recognitions sum;
    for (int i = 0; i < measuredBuildings(10); ++i) {
        recogniseIn(settings, firstSeed(701) + static_cast<std::uint64_t>(i), 2.0, sum);
        print("so far", sum);
    }
    print("place recognition among twins", sum);
    EXPECT_GT(sum.revisits, 0);
    EXPECT_EQ(sum.askedWrongly, 0);
}

}  // namespace
}  // namespace leitstand::simulation::test
