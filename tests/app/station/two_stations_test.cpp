#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>

#include "app/services/finds/find_desk.h"
#include "app/services/log/live_mission.h"
#include "app/services/places/mission_map.h"
#include "app/services/station/station_clock.h"
#include "core/event/find_sample.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "tests/app/station/scanning_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// Two stations in one domain that hear the same robot: the first one there makes the map.
class TwoStations : public ScanningScene {
protected:
    void openFirst() { m_first = stationFor({m_description}, "first"); }
    void openSecond() { m_second = stationFor({m_description}, "second"); }
    void receive() {
        m_hearing.clear();
        for (Station* one : {m_first.get(), m_second.get()}) {
            if (one != nullptr) m_hearing.push_back(one);
        }
    }
    [[nodiscard]] static std::vector<std::uint64_t> ids(Station& station) {
        std::vector<std::uint64_t> all;
        const LiveMapPtr map = station.mapping().scans();
        for (const LiveKeyScan& scan : map->scans) all.push_back(scan.id);
        return all;
    }
    [[nodiscard]] static bool has(Station& station, std::size_t count) {
        return waitUntil([&] { return station.mapping().scans()->scans.size() == count; }, 60s);
    }
    [[nodiscard]] static std::optional<ScanTrust> trust(Station& station, std::uint64_t id) {
        const LiveMapPtr map = station.mapping().scans();
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.id == id) return scan.pose.trust;
        }
        return std::nullopt;
    }
    /// Whether the log of the station @p name has links to all of @p scans.
    [[nodiscard]] bool linksCome(const std::string& name, const std::set<std::uint64_t>& scans) const {
        return waitUntil(
            [&] {
                std::set<std::uint64_t> linked;
                for (const ScanLinksSample& sample : scanLinksOf(m_folder / (name + "-mission"))) {
                    for (const Link& link : sample.links) linked.insert(link.to);
                }
                return std::includes(linked.begin(), linked.end(), scans.begin(), scans.end());
            },
            60s);
    }
    [[nodiscard]] static bool becomes(Station& station, std::uint64_t id, ScanTrust wanted) {
        return waitUntil([&] { return trust(station, id) == wanted; }, 60s);
    }
    [[nodiscard]] static std::optional<FindSample> victim(Station& station, std::uint32_t number) {
        const MissionStatePtr mission = station.mission();
        const auto known = mission->finds->find({FindSample::Kind::Victim, number});
        return known == mission->finds->end() ? std::nullopt : std::optional(known->second.victim);
    }
    [[nodiscard]] static const RobotInMap& robot(const RobotsInMapPtr& robots) { return robots->front(); }

    std::unique_ptr<Station> m_first, m_second;
};

TEST_F(TwoStations, TheSecondShowsTheMapThatTheFirstMakesAndWhatIsDecidedOfIt) {
    openFirst();
    receive();
    ASSERT_TRUE(holdsMap(*m_first)) << words();
    for (int i = 0; i < 3; ++i) scan();
    ASSERT_TRUE(has(*m_first, 3)) << words();
    openSecond();  // what was before comes to who comes late ...
    ASSERT_TRUE(has(*m_second, 3)) << words();
    receive();
    scan();  // ... and then what is new
    ASSERT_TRUE(has(*m_first, 4)) << words();
    ASSERT_TRUE(has(*m_second, 4)) << words();
    const LiveMapPtr made = m_first->mapping().scans();
    ASSERT_TRUE(waitUntil([&] {
        const LiveMapPtr shown = m_second->mapping().scans();
        return std::equal(made->scans.begin(), made->scans.end(), shown->scans.begin(), shown->scans.end(),
                          [](const LiveKeyScan& a, const LiveKeyScan& b) {
                              return a.id == b.id && a.pose.trust == b.pose.trust &&
                                     a.scan->points.size() == b.scan->points.size() &&
                                     a.pose.scanInMap.isApprox(b.pose.scanInMap, 1e-9);
                          });
    })) << words();
    ASSERT_TRUE(waitUntil([&] { return robot(m_second->mapping().robots()).placed; }));
    const Pose apart = robot(m_first->mapping().robots()).baseInMap.inverse() *
                       robot(m_second->mapping().robots()).baseInMap;
    EXPECT_LT(apart.translation().norm(), 0.02) << "the robot, too";
    EXPECT_TRUE(waitUntil([&] { return robot(m_second->mapping().robots()).matched == m_time; }))
        << "what comes in is laid onto the map over there: it is not stale";

    EXPECT_THAT(m_second->mapping().reject(2).error().text, HasSubstr("another station"));
    ASSERT_TRUE(m_first->mapping().reject(2).ok());
    EXPECT_TRUE(becomes(*m_second, 2, ScanTrust::SetAside)) << words();
    ASSERT_TRUE(m_first->mapping().undo().ok());
    EXPECT_TRUE(becomes(*m_second, 2, ScanTrust::Certain)) << words();
    MapCrop area;
    area.polygon = {{-10.0, -10.0}, {1.2, -10.0}, {1.2, 10.0}, {-10.0, 10.0}};
    ASSERT_TRUE(m_first->mapping().setCrop(area).ok());
    EXPECT_TRUE(waitUntil([&] { return m_second->mapping().crop().polygon == area.polygon; })) << words();
    ASSERT_TRUE(m_first->mapping().undo().ok());
    EXPECT_TRUE(waitUntil([&] { return m_second->mapping().crop().open(); })) << words();

    m_second.reset();
    openSecond();
    EXPECT_THAT(ids(*m_second), ElementsAre(1, 2, 3, 4)) << "its own log has all of it";
    m_second.reset();
    m_first.reset();
    const auto log = must(BagReader::open(m_folder / "second-mission"));
    EXPECT_EQ(keyScansOf(*log).size(), 4u) << "and no scan twice";
}

TEST_F(TwoStations, TheSecondGoesOnWithTheMapWhereTheFirstEndsAndTheFirstFollows) {
    openFirst();
    ASSERT_TRUE(holdsMap(*m_first)) << words();
    openSecond();
    receive();
    for (int i = 0; i < 3; ++i) scan();
    ASSERT_TRUE(has(*m_second, 3)) << words();
    m_first.reset();
    receive();
    ASSERT_TRUE(holdsMap(*m_second)) << words();
    scan();
    ASSERT_TRUE(has(*m_second, 4)) << words();
    EXPECT_THAT(ids(*m_second), ElementsAre(1, 2, 3, 1001));
    EXPECT_EQ(trust(*m_second, 1001), ScanTrust::Certain) << "it fits the map of the first";
    openFirst();
    EXPECT_TRUE(waitUntil([&] { return ids(*m_first) == ids(*m_second); }, 60s)) << words();
    EXPECT_THAT(m_first->mapping().reject(1).error().text, HasSubstr("another station"));
    EXPECT_TRUE(linksCome("second", {2, 3, 1001})) << "what each scan was registered against";
    EXPECT_TRUE(linksCome("first", {2, 3, 1001}));
}

TEST_F(TwoStations, TheMapIsHandedOverByWhoMakesIt) {
    openFirst();
    ASSERT_TRUE(holdsMap(*m_first)) << words();
    openSecond();
    receive();
    scan();
    ASSERT_TRUE(has(*m_second, 1)) << words();
    ASSERT_TRUE(waitUntil([&] { return m_first->mapGrant().requestedByTitle == "Test desk"; }));
    EXPECT_TRUE(m_first->mapGrant().mine);
    m_second->giveMap();  // it has nothing to give
    m_first->giveMap();
    ASSERT_TRUE(holdsMap(*m_second)) << words();
    EXPECT_FALSE(m_first->mapGrant().mine);
    scan();
    EXPECT_TRUE(waitUntil(
        [&] {
            return ids(*m_first) == std::vector<std::uint64_t>{1, 1001};
        },
        60s))
        << words();
    EXPECT_EQ(ids(*m_second), ids(*m_first));
    m_second.reset();
    EXPECT_TRUE(holdsMap(*m_first)) << "it goes on here when the other one ends";
}

TEST_F(TwoStations, FindsThatWereFiledUnheardAreAllKeptWhenStationsMeet) {
    // Each files two with nobody else there.
    const auto file = [&](Station& station, double y) {
        for (const double x : {1.0, 3.0}) {
            const auto before = station.mission()->finds->size();
            station.finds().freezeAt(m_description.name, FindSample::Kind::Victim, {x, y, -0.8});
            ASSERT_TRUE(waitUntil([&] { return station.mission()->finds->size() > before; })) << words();
        }
    };
    openFirst();
    file(*m_first, 2.0);
    m_first.reset();
    openSecond();
    file(*m_second, -2.0);
    openFirst();
    const auto places = [](Station& station) {
        std::vector<std::pair<std::uint32_t, double>> all;
        const MissionStatePtr mission = station.mission();
        for (const auto& [key, find] : *mission->finds)
            all.emplace_back(key.second, find.victim.positionInMap.y());
        return all;
    };
    using testing::Pair;
    const auto whole = ElementsAre(Pair(1, 2.0), Pair(2, 2.0), Pair(3, -2.0), Pair(4, -2.0));
    for (Station* one : {m_first.get(), m_second.get()}) {
        EXPECT_TRUE(waitUntil([&] { return testing::Value(places(*one), whole); }))
            << testing::PrintToString(places(*one)) << words();
    }
    EXPECT_THAT(words(), HasSubstr("V1 is V3 now"));
}

using LongTwoStations = TwoStations;

TEST_F(LongTwoStations, WhoComesLateGetsALongMapWhole) {
    // As a log has it: a hundred scans of what a turn weighs, which no test would wait for.
    constexpr std::size_t Many = 100;
    {
        LiveMissionSettings log = settingsFor({m_description}, "first").mission;
        log.station = "first";
        const auto mission = must(LiveMission::open(log));
        auto points = std::make_shared<Scan>();
        points->robot = m_description.name;
        points->hasOdometry = true;
        for (int i = 0; i < 15'000; ++i)
            points->points.emplace_back(0.5F + 0.001F * static_cast<float>(i % 4'000),
                                        0.02F * static_cast<float>(i % 97),
                                        0.01F * static_cast<float>(i % 61));
        points->labels.assign(points->points.size(), Label::Wall);
        for (std::uint64_t id = 1; id <= Many; ++id) {
            KeyScanSample scan;
            scan.id = id;
            scan.stamp = m_time + std::chrono::seconds(id);
            scan.scan = points;
            scan.scanInMap = poseFrom({0.3 * static_cast<double>(id), 0, 0}, 0, 0, 0);
            ASSERT_TRUE(mission->record(scan, station_topic::KeyScans).ok());
        }
    }
    openFirst();
    ASSERT_TRUE(has(*m_first, Many)) << words();
    ASSERT_TRUE(holdsMap(*m_first)) << words();
    openSecond();
    ASSERT_TRUE(waitUntil([&] { return m_second->mission()->keyScans->size() == Many; }, 120s))
        << m_second->mission()->keyScans->size() << " came; " << words();
    EXPECT_TRUE(has(*m_second, Many)) << words();
    EXPECT_EQ(m_second->mission()->remarks->size(), 0u);
}

TEST_F(TwoStations, FindsAndTheClockAreTheTeams) {
    openFirst();
    ASSERT_TRUE(holdsMap(*m_first)) << words();
    ASSERT_TRUE(m_first->clock().run(false).ok());
    ASSERT_TRUE(m_first->clock().limit(20min).ok());
    openSecond();
    EXPECT_TRUE(waitUntil([&] { return m_second->clock().now().limit == 20min; })) << words();
    EXPECT_FALSE(m_second->clock().now().running);
    receive();
    scan();
    ASSERT_TRUE(has(*m_second, 1)) << words();
    m_second->finds().freezeAt(m_description.name, FindSample::Kind::Victim, {1.0, 0.5, -0.8});
    ASSERT_TRUE(waitUntil([&] { return victim(*m_first, 1).has_value(); })) << words();
    EXPECT_LT((victim(*m_first, 1)->positionInMap - Eigen::Vector3d(1.0, 0.5, -0.8)).head<2>().norm(), 1e-6);
    const FindKey found{FindSample::Kind::Victim, 1};
    ASSERT_TRUE(m_first->finds().confirm(found).ok()) << "whoever filed it";
    EXPECT_TRUE(waitUntil([&] { return victim(*m_second, 1)->status == FindSample::Status::Confirmed; }));
    ASSERT_TRUE(m_first->finds().undo().ok());
    EXPECT_TRUE(waitUntil([&] { return victim(*m_second, 1)->status == FindSample::Status::Hypothesis; }));
    m_second->finds().freezeAt(m_description.name, FindSample::Kind::Victim, {2.0, -0.5, -0.8});
    ASSERT_TRUE(waitUntil([&] { return victim(*m_first, 2).has_value(); })) << "no number twice; " << words();
    ASSERT_TRUE(m_second->finds().undo().ok());
    EXPECT_TRUE(waitUntil([&] { return victim(*m_first, 2)->status == FindSample::Status::Discarded; }))
        << "that it was filed is taken back";
    ASSERT_TRUE(m_second->clock().run(true).ok());
    EXPECT_TRUE(waitUntil([&] { return m_first->clock().now().running; }));
}

}  // namespace
}  // namespace leitstand::test
