#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/relocalisation/parts_meeting.h"
#include "core/mapping/relocalisation/place_recognition.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/simulation/mapping/two_drives.h"

namespace leitstand::simulation::test {
namespace {

constexpr double Off = 0.3, OffAngle = degrees(3);  ///< a link is wrong from there on

/// What came of mapping them together.
struct TwoMapped {
    bool together = false;  ///< in the end
    int wrong = 0;          ///< links that were asked about and are none
    double until = 0.0;     ///< way of both between them since one came to where the other had been [m]
    double worstLink = 0.0, ate = 0.0, seam = 0.0;  ///< [m]
    double seeking = 0.0;                           ///< processor time [s]
};

class TogetherMapped {
public:
    /// All robots but the first one begin parts.
    explicit TogetherMapped(const std::vector<const ScriptedDrive*>& drives) : m_mapper("test", {}) {
        for (const ScriptedDrive* const drive : drives) {
            const std::string& robot = drive->scans.front().scan->robot;
            if (!m_drives.empty()) m_mapper.beginPart(robot);
            m_drives.emplace_back(robot, drive);
            m_mapper.setBody(robot, {drive->drive.robot.footprint, drive->drive.robot.height});
        }
    }

    /// Nobody looks for the one in the other while they drive; afterwards everything of them is compared.
    /// @p few: joined at the first places that agree alone, as where an operator answers a question.
    TwoMapped runApart(bool few = false) {
        for (const LiveScan& live : inOrder()) {
            (void)m_mapper.add(live, live.scan->end);
            follow(*live.scan);
            (void)m_mapper.sought();
            if (const auto problem = m_mapper.problem())
                (void)m_mapper.settle(solve(*problem), live.scan->end);
        }
        const LiveMapPtr map = m_mapper.map();
        const auto second = std::find_if(map->scans.begin(), map->scans.end(),
                                         [](const LiveKeyScan& scan) { return scan.part == scan.id; });
        const double began = processorTime();
        PartsMeeting meeting = meetingOf(map, second->part, {});
        m_result.seeking = processorTime() - began;
        std::printf("  %zu of %zu places found, %zu agree\n", meeting.found, meeting.sought,
                    meeting.scansInMap.size());
        while (few && meeting.scansInMap.size() > LoopSettings{}.partsAgree)
            meeting.scansInMap.erase(std::prev(meeting.scansInMap.end()));
        const Time now = inOrder().back().scan->end;
        if (auto links = m_mapper.join(meeting.scansInMap, now)) {
            compare(*links);
            if (const auto problem = m_mapper.problem()) (void)m_mapper.settle(solve(*problem), now);
        }
        if (few) {
            judge();
            std::printf("  before they were linked all over: worst seam %.3f m\n", m_result.seam);
        }
        meetMore(now);
        judge();
        return m_result;
    }

    TwoMapped run() {
        for (const LiveScan& live : inOrder()) {
            const MapUpdate update = m_mapper.add(live, live.scan->end);
            if (update.loop) answer(*update.loop, live.scan->end);
            follow(*live.scan);
            seek(live.scan->end);
            if (const auto problem = m_mapper.problem())
                (void)m_mapper.settle(solve(*problem), live.scan->end);
            meetMore(live.scan->end);
        }
        judge();
        return m_result;
    }

private:
    /// Where parts came together, at all of their scans.
    void meetMore(Time now) {
        while (m_mapper.meetsMore()) {
            if (const auto links = m_mapper.meetMore(now)) compare(*links);
        }
        if (const auto problem = m_mapper.problem()) (void)m_mapper.settle(solve(*problem), now);
    }
    [[nodiscard]] std::vector<LiveScan> inOrder() const {
        std::vector<LiveScan> scans;
        for (const auto& [robot, drive] : m_drives)
            scans.insert(scans.end(), drive->scans.begin(), drive->scans.end());
        std::stable_sort(scans.begin(), scans.end(),
                         [](const LiveScan& a, const LiveScan& b) { return a.scan->end < b.scan->end; });
        return scans;
    }
    [[nodiscard]] Pose truthOf(const Scan& scan) const {
        const auto of = std::find_if(m_drives.begin(), m_drives.end(),
                                     [&](const auto& one) { return one.first == scan.robot; });
        return of->second->drive.baseInArena(scan.end);
    }

    /// How far both have come since their ways met.
    void follow(const Scan& scan) {
        const Pose here = truthOf(scan);
        std::vector<Pose>& mine = m_ways[scan.robot];
        for (const auto& [robot, way] : m_ways) {
            m_met =
                m_met || (robot != scan.robot && std::any_of(way.begin(), way.end(), [&](const Pose& pose) {
                              return distanceBetween(pose, here) < 1.5;
                          }));
        }
        if (m_met && !mine.empty() && !m_result.together)
            m_result.until += distanceBetween(mine.back(), here);
        mine.push_back(here);
    }

    void seek(Time now) {
        const auto sought = m_mapper.sought();
        if (!sought) return;
        const double began = processorTime();
        const auto found = recognise(*sought, {});
        m_result.seeking += processorTime() - began;
        const auto question =
            found ? m_mapper.recognised(*sought, *found, now) : std::optional<ScanLinksSample>{};
        if (question) answer(*question, now);
    }

    /// Whether all of @p found are true, as one finds who knows the truth.
    bool compare(const ScanLinksSample& found) {
        const LiveMapPtr map = m_mapper.map();
        bool right = true;
        for (const Link& link : found.links) {
            const Pose between = truth(*map, link.from).inverse() * truth(*map, link.to);
            const double off = distanceBetween(between, link.pose);
            const bool fits = off <= Off && angleBetween(between, link.pose) <= OffAngle;
            right = right && fits;
            if (!fits) ++m_result.wrong;
            if (fits) m_result.worstLink = std::max(m_result.worstLink, off);
        }
        return right;
    }
    [[nodiscard]] Pose truth(const LiveMap& map, std::uint64_t id) const {
        const auto scan = std::find_if(map.scans.begin(), map.scans.end(),
                                       [id](const LiveKeyScan& one) { return one.id == id; });
        return truthOf(*scan->scan) * scan->sensorInBase;
    }

    void answer(ScanLinksSample question, Time now) {
        if (question.links.front().active) return;
        const LiveMapPtr map = m_mapper.map();
        const bool right = compare(question);
        if (std::getenv("LEITSTAND_TELL") != nullptr) {
            const Link& newest = question.links.back();
            const Pose between = truth(*map, newest.from).inverse() * truth(*map, newest.to);
            std::printf(
                "  %s: %zu links, scans %llu and %llu, %.1f m and %.0f degrees off, truly %.1f m apart, %zu "
                "and "
                "%zu scans\n",
                right ? "right" : "wrong", question.links.size(),
                static_cast<unsigned long long>(newest.from), static_cast<unsigned long long>(newest.to),
                distanceBetween(between, newest.pose), inDegrees(angleBetween(between, newest.pose)),
                between.translation().norm(), m_ways["kurt3d"].size(), m_ways["second"].size());
        }
        for (Link& link : question.links) {
            link.kind = LinkKind::Operator;
            link.active = right;
        }
        question.stamp = now;
        m_mapper.restore(question);
        m_result.together = m_result.together || right;
    }

    void judge() {
        const LiveMapPtr map = m_mapper.map();
        m_result.together = !inParts(*map);
        Trajectory trajectory;
        for (const auto& [robot, drive] : m_drives) {
            for (const LiveKeyScan& key : map->scans) {
                if (key.scan->robot != robot || !key.counts()) continue;
                trajectory.found.push_back(key.pose.scanInMap * key.sensorInBase.inverse());
                trajectory.truth.push_back(truthOf(*key.scan));
            }
        }
        m_result.ate = errorOf(trajectory).distance;
        m_result.seam = worstSeam(trajectory);
    }

    std::vector<std::pair<std::string, const ScriptedDrive*>> m_drives;  ///< by robot
    LiveMapper m_mapper;
    TwoMapped m_result;
    bool m_met = false;
    std::map<std::string, std::vector<Pose>> m_ways;  ///< by robot
};

/// Of buildings in which the two maps came to be one.
struct Sum {
    int together = 0, wrong = 0;
    double ate = 0.0, seam = 0.0;  ///< the worst of those [m]
};

Sum mapTogether(const char* name, bool twins, const SensorErrors& sensor, std::uint64_t first, int count,
                bool afterwards = false, bool few = false) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    settings.twins = twins;
    Sum sum;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(first) + static_cast<std::uint64_t>(i);
        const Building building = std::move(generateBuilding(settings, seed)).value();
        const TwoDrives drives = twoDrives(building, sensor, seed);
        TogetherMapped mapped({&drives.first, &drives.second});
        const TwoMapped one = afterwards ? mapped.runApart(few) : mapped.run();
        std::printf(
            "%s %llu: %s after %.1f m of both ways, link off by %.3f m, %d wrong links asked, ATE %.3f m, "
            "worst "
            "seam %.3f m, %.0f s of a core looked for\n",
            name, static_cast<unsigned long long>(seed), one.together ? "together" : "apart", one.until,
            one.worstLink, one.wrong, one.ate, one.seam, one.seeking);
        sum.wrong += one.wrong;
        if (!one.together) continue;
        ++sum.together;
        sum.ate = std::max(sum.ate, one.ate);
        sum.seam = std::max(sum.seam, one.seam);
    }
    std::printf("%s: %d of %d together, %d wrong links asked\n", name, sum.together, count, sum.wrong);
    return sum;
}

TEST(TwoMappersLong, WhoMeetsTheOthersWayComesIntoOneMapWithIt) {
    const int count = measuredBuildings(10);
    const Sum sum = mapTogether("two robots", false, {}, 801, count);
    EXPECT_GE(sum.together, 0.9 * count);
    EXPECT_EQ(sum.wrong, 0);
    EXPECT_LT(sum.ate, 0.04);
    EXPECT_LT(sum.seam, 0.06);
}

TEST(TwoMappersLong, ThreeRobotsComeIntoOneMap) {
    const int count = std::min(measuredBuildings(10), 3);
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(881) + static_cast<std::uint64_t>(i);
        BuildingSettings settings;
        settings.width = 30.0;
        settings.depth = 20.0;
        const Building building = std::move(generateBuilding(settings, seed)).value();
        const TwoDrives drives = twoDrives(building, {}, seed);
        ScriptSettings script;
        script.seed = seed + 9000;
        ScriptedDrive third =
            scriptedDrive(building.arena, DrivePath(stretch(building.ways, 0.95, 0.45)), script);
        rename(third, "third");
        const TwoMapped one = TogetherMapped({&drives.first, &drives.second, &third}).run();
        std::printf(
            "three robots %llu: %s, link off by %.3f m, %d wrong links asked, ATE %.3f m, worst seam %.3f "
            "m\n",
            static_cast<unsigned long long>(seed), one.together ? "together" : "apart", one.worstLink,
            one.wrong, one.ate, one.seam);
        EXPECT_TRUE(one.together) << "seed " << seed;
        EXPECT_EQ(one.wrong, 0);
        EXPECT_LT(one.ate, 0.04);
        EXPECT_LT(one.seam, 0.06);
    }
}

TEST(TwoMappersLong, WithRealScanners) {
    const int count = std::min(measuredBuildings(10), 5);
    const Sum sum = mapTogether("two robots with real scanners", false, realScanner(), 811, count);
    EXPECT_GE(sum.together, 0.8 * count);
    EXPECT_EQ(sum.wrong, 0);
}

TEST(TwoMappersLong, AmongTwins) {
    const int count = std::min(measuredBuildings(10), 5);
    const Sum sum = mapTogether("two robots among twins", true, {}, 821, count);
    EXPECT_GE(sum.together, 0.8 * count) << "whatever was asked before and answered with no";
    EXPECT_LT(sum.ate, 0.04);
}

TEST(TwoMappersLong, WhatWasMappedApartComesIntoOneMapAfterwards) {
    const int count = measuredBuildings(10);
    const Sum sum = mapTogether("two maps", false, {}, 831, count, true);
    EXPECT_GE(sum.together, 0.9 * count);
    EXPECT_EQ(sum.wrong, 0);
    EXPECT_LT(sum.ate, 0.05);
    EXPECT_LT(sum.seam, 0.08);
}

TEST(TwoMappersLong, WhatIsJoinedAtAFewPlacesIsLinkedAllOver) {
    const int count = std::min(measuredBuildings(10), 5);
    const Sum sum = mapTogether("two maps, joined at three places", false, {}, 831, count, true, true);
    EXPECT_GE(sum.together, 0.8 * count);
    EXPECT_EQ(sum.wrong, 0);
    EXPECT_LT(sum.ate, 0.05);
    EXPECT_LT(sum.seam, 0.08);
}

TEST(TwoMappersLong, WhatWasMappedApartAmongTwins) {
    const int count = std::min(measuredBuildings(10), 5);
    const Sum sum = mapTogether("two maps among twins", true, realScanner(), 841, count, true);
    EXPECT_EQ(sum.wrong, 0) << "side by side is right where nobody can tell";
    EXPECT_GE(sum.together, 0.6 * count);
}

/// The second mission is of another building.
TEST(TwoMappersLong, WhatIsElsewhereStaysApart) {
    const int count = std::min(measuredBuildings(10), 5);
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(851) + static_cast<std::uint64_t>(i);
        BuildingSettings settings;
        settings.width = 30.0;
        settings.depth = 20.0;
        const Building here = std::move(generateBuilding(settings, seed)).value();
        const Building there = std::move(generateBuilding(settings, seed + 1000)).value();
        TwoDrives drives = twoDrives(here, {}, seed);
        drives.second = twoDrives(there, {}, seed + 1000).second;
        EXPECT_FALSE(TogetherMapped({&drives.first, &drives.second}).runApart().together) << "seed " << seed;
    }
}

}  // namespace
}  // namespace leitstand::simulation::test
