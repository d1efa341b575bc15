// The main job: a building of two storeys, explored by both robots as processes of their own, as an operator
// sends them from a station, within half an hour; and what is handed in then.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/services/finds/find_desk.h"
#include "app/services/station/station.h"
#include "app/services/station/station_mapping.h"
#include "core/event/find_sample.h"
#include "core/io/handin/find_lists.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/state/scan_state.h"
#include "robots/simulation/arena/building_generator.h"
#include "robots/simulation/process/truth_exchange.h"
#include "tests/app/explored/arena_truth.h"
#include "tests/app/explored/toured_by_station.h"
#include "tests/app/recording.h"
#include "tests/app/robots/robot_process.h"
#include "tests/simulation/mapping/building_tour.h"
#include "tests/simulation/mapping/measured_seed.h"
#include "tests/simulation/mapping/trajectory.h"
#include "tests/support/latency.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using simulation::test::BuildingTour;
using simulation::test::roomsInOrder;
using simulation::test::Trajectory;
using Clock = std::chrono::steady_clock;

constexpr double HalfAnHour = 1800.0;      ///< [s]
constexpr std::chrono::seconds Stands(4);  ///< until it is sent: a turn of the scanner, and some
constexpr double Sees = 2.5;               ///< a victim, whoever stands so near to it [m]
constexpr double Shows = 4.0;              ///< likewise, a scan taken so near to it [m]
constexpr double SameStorey = 1.0;         ///< [m]
constexpr double LoopIsRight = 0.3;        ///< by the truth [m]
const std::vector<std::string> Robots = {"kurt3d", "crawler"};

/// A victim of the arena, and what became of it.
struct Victim {
    std::string name;
    Eigen::Vector3d inArena = Eigen::Vector3d::Zero();
    bool filed = false;
};

/// Where a robot was shown in the map, and where it was.
struct Shown {
    Pose inMap, inArena;
    bool certain = false;
};

/// An operator at a station: sends both robots on their tours, files victims by pointing at them on the map,
/// and answers whether the map meets itself.
class Operator {
public:
    Operator(const simulation::Building& building, const TestDomain& domain,
             const std::filesystem::path& mission, const std::filesystem::path& memory)
        : m_truth(domain, simulation::topicPart(building.arena), Robots) {
        StationSettings settings;
        settings.domain.domain = domain.number();
        settings.mission.folder = mission;
        settings.mission.title = "Building";
        for (const std::string& robot : Robots) settings.mission.robots.push_back(shippedRobot(robot));
        settings.memory = memory;
        StationListener listener;
        listener.onMessage = [this](const std::string& text) {
            const std::scoped_lock lock(m_mutex);
            m_messages.push_back(text);
        };
        m_station = must(Station::open(settings, std::move(listener)));
        for (const simulation::Element& element : building.arena.elements) {
            if (element.kind == simulation::ElementKind::Victim)
                m_victims.push_back({element.name, element.pose.translation()});
        }
        for (const std::string& robot : Robots)
            m_robots.push_back(std::make_unique<TouredByStation>(*m_station, m_truth, robot));
        std::vector<Eigen::Vector3d> back = roomsInOrder(building, 1);
        std::reverse(back.begin(), back.end());
        m_tours.push_back(std::make_unique<BuildingTour>(*m_robots[0], roomsInOrder(building, 2)));
        m_tours.push_back(std::make_unique<BuildingTour>(*m_robots[1], std::move(back)));
    }
    [[nodiscard]] bool begins() {
        return waitUntil(
            [&] {
                return std::all_of(Robots.begin(), Robots.end(), [&](const std::string& robot) {
                    m_station->requestGrant(robot);
                    return m_station->robot(robot).grant.mine && m_truth.newest(robot) &&
                           m_station->robot(robot).link.state == LinkState::Connected;
                });
            },
            60s);
    }
    void works(double longest) {
        const auto began = Clock::now();
        int minutes = 0, looks = 0;
        auto next = began;
        std::this_thread::sleep_for(Stands);
        while (seconds(began) < longest && !(m_tours[0]->isOver() && m_tours[1]->isOver())) {
            for (const auto& tour : m_tours) tour->look();
            files();
            if (++looks % 10 == 0) {
                watches();
                answers();
            }
            highest = std::max(highest, m_robots[0]->baseInArena().translation().z());
            if (seconds(began) > 60.0 * (minutes + 1)) tells(++minutes);
            std::this_thread::sleep_until(next += 50ms);
        }
        took = seconds(began);
    }
    [[nodiscard]] const BuildingTour& kurt3ds() const { return *m_tours[0]; }
    [[nodiscard]] const ArenaTruth& truth() const { return m_truth; }
    [[nodiscard]] const std::vector<Victim>& victims() const { return m_victims; }
    [[nodiscard]] const std::map<std::string, std::vector<Shown>>& shown() const { return m_shown; }
    [[nodiscard]] LiveMapPtr map() const { return m_station->mapping().scans(); }
    /// Key scans, where the map has them and where they were taken; @p counting: those that count.
    [[nodiscard]] Trajectory keyScans(bool counting) const {
        Trajectory trajectory;
        for (const LiveKeyScan& key : map()->scans) {
            const auto truth = m_truth.at("kurt3d", key.scan->end);
            if (!truth || (counting && !key.counts())) continue;
            trajectory.found.push_back(key.pose.scanInMap * key.sensorInBase.inverse());
            trajectory.truth.push_back(*truth);
        }
        return trajectory;
    }

    double took = 0.0, highest = 0.0;  ///< [s, m]
    int asked = 0;                     ///< whether the map meets itself
    std::uint32_t filed = 0;

private:
    static double seconds(Clock::time_point since) {
        return std::chrono::duration<double>(Clock::now() - since).count();
    }
    /// Points at each victim on the map that a robot is near to, where the nearest scan that counts shows it.
    void files() {
        if (m_station->finds().isFiling()) return;
        if (m_filing && m_station->finds().filings() > m_filings) {
            EXPECT_TRUE(m_station->finds().confirmNewest()) << m_filing->name;
            m_filing->filed = true;
            m_filing = nullptr;
            ++filed;
        }
        if (m_filing) return;
        for (const std::string& robot : Robots) {
            const auto base = m_truth.newest(robot);
            for (Victim& victim : m_victims) {
                const Eigen::Vector3d off = victim.inArena - base->translation();
                if (victim.filed || off.norm() > Sees || std::abs(off.z()) > SameStorey) continue;
                const auto place = onMap(victim.inArena);
                if (!place) continue;
                m_filings = m_station->finds().filings();
                m_filing = &victim;
                m_station->finds().freezeAt(robot, FindSample::Kind::Victim, *place);
                return;
            }
        }
    }
    /// Where the map shows what is at @p inArena: as the nearest scan that counts has it.
    [[nodiscard]] std::optional<Eigen::Vector3d> onMap(const Eigen::Vector3d& inArena) const {
        std::optional<Eigen::Vector3d> place;
        double nearest = Shows;
        for (const LiveKeyScan& key : map()->scans) {
            const auto base = m_truth.at("kurt3d", key.scan->end);
            if (!base || !key.counts()) continue;
            const Eigen::Vector3d inScan = (*base * key.sensorInBase).inverse() * inArena;
            if (inScan.norm() > nearest) continue;
            nearest = inScan.norm();
            place = key.pose.scanInMap * inScan;
        }
        return place;
    }
    /// Remembers where the map shows robots.
    void watches() {
        const RobotsInMapPtr robots = m_station->mapping().robots();
        for (const RobotInMap& robot : *robots) {
            if (!robot.placed) continue;
            if (const auto base = m_truth.at(robot.robot, robot.stamp))
                m_shown[robot.robot].push_back({robot.baseInMap, *base, robot.certain});
        }
    }
    /// Whether the two places of the open question are one, as somebody knows who has been there.
    void answers() {
        const auto loop = openLoop(*m_station->mission());
        if (!loop) return;
        const LiveMapPtr scans = map();
        const auto taken = [&](std::uint64_t id) -> std::optional<Pose> {
            for (const LiveKeyScan& key : scans->scans) {
                if (key.id != id) continue;
                const auto base = m_truth.at("kurt3d", key.scan->end);
                return base ? std::optional(*base * key.sensorInBase) : std::nullopt;
            }
            return std::nullopt;
        };
        const auto from = taken(loop->links.front().from), to = taken(loop->links.front().to);
        if (!from || !to) return;
        const Pose truth = from->inverse() * *to;
        const bool same = (truth.translation() - loop->links.front().pose.translation()).norm() < LoopIsRight;
        ++asked;
        std::printf("        asked: a seam of %.2f m; %s\n", loop->seam(), same ? "yes" : "no");
        EXPECT_TRUE(m_station->mapping().answerLoop(*loop, same));
    }
    void tells(int minute) {
        std::printf("%3d min: kurt3d %s\n         crawler %s\n", minute, m_tours[0]->doing().c_str(),
                    m_tours[1]->doing().c_str());
        const std::scoped_lock lock(m_mutex);
        for (const std::string& message : m_messages) std::printf("        %s\n", message.c_str());
        m_messages.clear();
        std::fflush(stdout);
    }

    ArenaTruth m_truth;
    std::mutex m_mutex;
    std::vector<std::string> m_messages;
    std::vector<Victim> m_victims;
    Victim* m_filing = nullptr;
    std::uint64_t m_filings = 0;
    std::map<std::string, std::vector<Shown>> m_shown;
    std::unique_ptr<Station> m_station;
    std::vector<std::unique_ptr<TouredByStation>> m_robots;
    std::vector<std::unique_ptr<BuildingTour>> m_tours;
};

/// The list of things found in @p folder, in which only one mission was handed in.
FindList handedIn(const std::filesystem::path& folder) {
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        if (file.path().string().ends_with(endingOf(FindList::Kind::Pois))) return must(readFindList(file));
    }
    ADD_FAILURE() << "no list in " << folder;
    return {};
}

TEST(ExploredMissionLong, ABuildingOfTwoStoreysIsExploredAndHandedInRightToFiveCentimetres) {
    const std::uint64_t seed = simulation::test::measuredSeed();
    simulation::BuildingSettings building;
    building.width = 30.0;
    building.depth = 20.0;
    building.storeys = 2;
    const simulation::Building made = must(simulation::generateBuilding(building, seed));
    const TemporaryFolder folder;
    const TestDomain domain;
    const std::vector<std::string> there = {"--arena", "building", "--seed",    std::to_string(seed),
                                            "--size",  "30x20",    "--storeys", "2"};
    std::map<std::string, Eigen::Vector3d> filed;
    Pose mapInArena = Pose::Identity();
    {
        const RobotProcess kurt3d(domain, "kurt3d", there), crawler(domain, "crawler", there);
        Operator desk(made, domain, folder / "mission", folder / "station.yaml");
        ASSERT_TRUE(desk.begins());
        desk.works(HalfAnHour);

        const Trajectory all = desk.keyScans(false);
        ASSERT_GE(all.found.size(), 100U);
        const auto error = simulation::test::errorOf(all);
        mapInArena = error.mapInArena;
        const double seam = simulation::test::worstSeam(desk.keyScans(true));
        const auto uncertain = std::count_if(desk.map()->scans.begin(), desk.map()->scans.end(),
                                             [](const LiveKeyScan& key) { return !key.counts(); });
        std::printf(
            "building %llu: %.0f s, kurt3d %.0f m, crawler %.0f m, %zu of %zu places, %zu times pulled back; "
            "%zu key scans, %td do not count; asked %d times; ATE %.3f m, worst seam %.3f m\n",
            static_cast<unsigned long long>(seed), desk.took, desk.truth().way("kurt3d"),
            desk.truth().way("crawler"), desk.kurt3ds().reached(), desk.kurt3ds().places(),
            desk.kurt3ds().pulledBack(), all.found.size(), uncertain, desk.asked, error.distance, seam);
        for (const auto& [robot, shown] : desk.shown()) {
            for (const bool certain : {true, false}) {
                std::vector<double> off;
                for (const Shown& one : shown) {
                    if (one.certain == certain)
                        off.push_back(
                            (mapInArena * one.inMap.translation() - one.inArena.translation()).norm());
                }
                if (off.empty()) continue;
                std::printf(
                    "    %s, %s %zu of %zu times, was shown %.3f m off (median), %.3f m (95 %%), %.3f m "
                    "(worst)\n",
                    robot.c_str(), certain ? "certain" : "doubted", off.size(), shown.size(),
                    quantile(off, 0.5), quantile(off, 0.95), quantile(off, 1.0));
            }
        }
        EXPECT_GT(desk.highest, 0.9 * made.ways.storeyHeight) << "up the ramp";
        EXPECT_GE(static_cast<double>(desk.kurt3ds().reached()),
                  0.75 * static_cast<double>(desk.kurt3ds().places()));
        EXPECT_LE(error.distance, 0.05);
        EXPECT_LE(seam, 0.10);
        EXPECT_GE(desk.filed, 4U);
        for (const Victim& victim : desk.victims()) {
            if (victim.filed) filed[victim.name] = victim.inArena;
        }
    }
    const auto report =
        leitstandctl({"report", (folder / "mission").string(), "--out", (folder / "report").string()});
    ASSERT_EQ(report.exitCode, 0) << report.err;
    const FindList list = handedIn(folder / "report");
    std::size_t listed = 0;
    for (const ListedFind& find : list.finds) {
        if (find.type != "victim") continue;
        ++listed;
        const Eigen::Vector3d place = mapInArena * find.position;
        double off = std::numeric_limits<double>::infinity();
        for (const auto& [name, inArena] : filed) off = std::min(off, (place - inArena).norm());
        std::printf("    %s is handed in %.3f m off\n", find.text.c_str(), off);
        EXPECT_LE(off, 0.05) << find.text;
    }
    EXPECT_GE(listed, filed.size());
}

}  // namespace
}  // namespace leitstand::test
