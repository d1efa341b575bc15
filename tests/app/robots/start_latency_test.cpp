#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/station/station.h"
#include "tests/app/recording.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// How processes of one start are told apart.
enum Part { Robot, Recorder, Desk, Parts };

struct StartSettings {
    int runs = 20;
    std::uint32_t seed = 1;
    double atMost = 3.0;  ///< until all is heard, from when the last of the three is there [s]
    bool keys = false;
};

/// Robot, recorder and station that start in an order and with offsets of chance: who has not heard what, and
/// how long it took until each heard everything.
class Starts {
public:
    explicit Starts(const StartSettings& settings) : m_settings(settings), m_random(settings.seed) {
        if (!settings.keys) return;
        const auto made = leitstandctl(
            {"keys", "--out", (m_folder / "keys").string(), "--station", "station1", "--robot", "kurt3d"});
        if (made.exitCode != 0) throw std::runtime_error(made.err);
    }

    void run() {
        for (int i = 0; i < m_settings.runs; ++i) once(i);
        std::sort(m_seconds.begin(), m_seconds.end());
        std::printf("%d starts: all heard after %.2f s (median), %.2f s at most\n", m_settings.runs,
                    m_seconds.at(m_seconds.size() / 2), m_seconds.back());
    }

private:
    std::vector<std::string> keysOf(const std::string& who) const {
        if (!m_settings.keys) return {};
        return {"--keys", (m_folder / "keys" / "enclaves" / who).string()};
    }
    std::unique_ptr<Station> desk(const TestDomain& domain, int run) const {
        StationSettings settings;
        settings.domain.domain = domain.number();
        if (m_settings.keys) settings.domain.keys = m_folder / "keys" / "enclaves" / "station1";
        settings.mission.folder = m_folder / ("desk" + std::to_string(run));
        settings.mission.robots = {m_robot};
        settings.mission.title = "Test desk";
        settings.memory = m_folder / "station.yaml";
        return must(Station::open(settings));
    }
    /// Topics of the robot's that come at a rate, and of which @p heard says nothing came.
    template <class Heard>
    std::vector<std::string> unheard(Heard heard) const {
        std::vector<std::string> topics;
        for (const StreamDescription& stream : m_robot.streams) {
            if (comesSteadily(stream.role) && stream.record && !heard(stream.topic))
                topics.push_back(stream.topic);
        }
        return topics;
    }

    void once(int run) {
        const TestDomain domain;
        const auto mission = m_folder / ("recorded" + std::to_string(run));
        std::array<int, Parts> order{Robot, Recorder, Desk};
        std::shuffle(order.begin(), order.end(), m_random);
        std::unique_ptr<ChildProcess> robot;
        std::unique_ptr<ChildProcess> recorder;
        std::unique_ptr<Station> station;
        std::string when;
        for (const int part : order) {
            const std::chrono::milliseconds offset(std::uniform_int_distribution<int>(0, 500)(m_random));
            when += " " + std::to_string(offset.count()) + " ms " +
                    std::array{"robot", "record", "desk"}[std::size_t(part)];
            std::this_thread::sleep_for(
                offset);  // what is tried is a start at this moment, whatever the others do
            std::vector<std::string> more = {"--domain", std::to_string(domain.number())};
            if (part == Robot) {
                more.insert(more.begin(), {"kurt3d", "--arena", "yellow", "--seed", "7"});
                for (const std::string& one : keysOf("kurt3d")) more.push_back(one);
                robot = std::make_unique<ChildProcess>(program("leitstand-robot"), more);
            } else if (part == Recorder) {
                more.insert(more.begin(), {"record", "--out", mission.string(), "--robot", "kurt3d"});
                for (const std::string& one : keysOf("station1")) more.push_back(one);
                recorder = std::make_unique<ChildProcess>(program("leitstandctl"), more);
            } else {
                station = desk(domain, run);
            }
        }
        ASSERT_TRUE(waitUntil([&] { return robot->out().find(" is in ") != std::string::npos; }, 60s))
            << robot->out();
        ASSERT_TRUE(
            waitUntil([&] { return recorder->out().find("recording domain") != std::string::npos; }, 60s))
            << recorder->out();
        const auto began = Clock::now();
        std::vector<std::string> atDesk, recorded;
        const bool all = waitUntil(
            [&] {
                const LinkStatus link = station->robot("kurt3d").link;
                atDesk = unheard([&](const std::string& topic) {
                    return std::any_of(link.streams.begin(), link.streams.end(),
                                       [&](const StreamStatus& stream) {
                                           return stream.topic == topic && stream.samples > 0;
                                       });
                });
                recorded =
                    unheard([&](const std::string& topic) { return !recordedOn(mission, topic).empty(); });
                return atDesk.empty() && recorded.empty();
            },
            std::chrono::milliseconds(static_cast<int>(2e3 * m_settings.atMost)));
        const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
        m_seconds.push_back(seconds);
        EXPECT_TRUE(all && seconds < m_settings.atMost)
            << "start " << run << " (" << when << "): after " << seconds
            << " s; not heard by the station: " << testing::PrintToString(atDesk)
            << ", by the recorder: " << testing::PrintToString(recorded) << "\n"
            << recorder->out();
        recorder->signal(SIGINT);
        EXPECT_EQ(recorder->wait(), 0) << recorder->out();
        robot->signal(SIGINT);
        EXPECT_EQ(robot->wait(), 0) << robot->out();
    }

    const StartSettings m_settings;
    std::mt19937 m_random;
    const TemporaryFolder m_folder;
    const RobotDescription m_robot = shippedRobot("kurt3d");
    std::vector<double> m_seconds;
};

TEST(StartLatency, RobotRecorderAndStationHearEachOtherInWhateverOrderTheyStart) {
    Starts({.runs = 20}).run();
}

TEST(StartLong, AHundredTimes) {
    Starts({.runs = 100, .seed = 2}).run();
}

TEST(StartLong, AHundredTimesWithKeys) {
    Starts({.runs = 100, .seed = 3, .atMost = 5.0, .keys = true}).run();
}

}  // namespace
}  // namespace leitstand::test
