#include "tests/app/robots/starts.h"

#include <cstdio>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/robot/streams/stream_table.h"
#include "tests/app/recording.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* Words[] = {"robot", "record", "desk", "adding"};

RadioConditions airOf(const StartSettings& settings) {
    RadioConditions air;
    air.bitsPerSecond = 100e6;  // for two that hear everything
    air.delay = 5ms;
    air.loss = settings.loss;
    air.mtu = 65'535;  // a datagram is lost or not, however large it is
    air.seed = settings.seed;
    return air;
}

/// Topics of @p robot's that come at a rate.
std::vector<std::string> steadyTopics(const RobotDescription& robot) {
    std::vector<std::string> topics;
    for (const StreamDescription& stream : robot.streams) {
        if (streamFacts(stream.role).steady && stream.record) topics.push_back(stream.topic);
    }
    return topics;
}

}  // namespace

Starts::Starts(const StartSettings& settings)
    : m_settings(settings),
      m_random(settings.seed),
      m_robot(shippedRobot(settings.stock ? "turtlebot" : "kurt3d")) {
    if (settings.stock || settings.loss > 0.0) {
        m_radio.emplace(airOf(settings));
        m_here.emplace(m_radio->station());
    }
    if (!settings.keys) return;
    const auto made = leitstandctl(
        {"keys", "--out", (m_folder / "keys").string(), "--station", "station1", "--robot", "kurt3d"});
    if (made.exitCode != 0) throw std::runtime_error(made.err);
}

double Starts::run() {
    for (int i = 0; i < m_settings.runs; ++i) once(i);
    if (m_seconds.empty()) return 0.0;
    std::sort(m_seconds.begin(), m_seconds.end());
    std::printf("%d starts: all heard after %.2f s (median), %.2f s at most\n", m_settings.runs,
                m_seconds.at(m_seconds.size() / 2), m_seconds.back());
    return m_seconds.at(m_seconds.size() / 2);
}

std::vector<Starts::Part> Starts::order() {
    std::vector<Part> parts = {Part::Robot, Part::Recorder, Part::Desk};
    std::shuffle(parts.begin(), parts.end(), m_random);
    if (m_settings.added) {
        const auto desk = std::find(parts.begin(), parts.end(), Part::Desk);
        const auto after = std::uniform_int_distribution<std::ptrdiff_t>(1, parts.end() - desk)(m_random);
        parts.insert(desk + after, Part::Adding);
    }
    return parts;
}

std::vector<std::string> Starts::keysOf(const std::string& who) const {
    if (!m_settings.keys) return {};
    return {"--keys", (m_folder / "keys" / "enclaves" / who).string()};
}

std::unique_ptr<ChildProcess> Starts::robot(const TestDomain& domain) const {
    std::optional<InNamespace> there;
    if (m_radio) there.emplace(m_radio->robots());
    const std::string number = std::to_string(domain.number());
    if (m_settings.stock)
        return std::make_unique<ChildProcess>(program("cyclone_robot"), std::vector{number});
    std::vector<std::string> words = {"kurt3d", "--arena", "yellow", "--seed", "7", "--domain", number};
    for (const std::string& one : keysOf("kurt3d")) words.push_back(one);
    return std::make_unique<ChildProcess>(program("leitstand-robot"), words);
}

std::unique_ptr<ChildProcess> Starts::recorder(const TestDomain& domain, const Run& run) const {
    std::vector<std::string> words = {"record", "--out", run.mission.string(), "--domain",
                                      std::to_string(domain.number())};
    if (!m_settings.added) words.insert(words.end(), {"--robot", m_robot.name});
    for (const std::string& one : keysOf("station1")) words.push_back(one);
    return std::make_unique<ChildProcess>(program("leitstandctl"), words);
}

std::unique_ptr<Station> Starts::desk(const TestDomain& domain, const Run& run, bool alone) const {
    StationSettings settings;
    settings.domain.domain = domain.number();
    if (m_settings.keys) settings.domain.keys = m_folder / "keys" / "enclaves" / "station1";
    settings.mission.folder = run.desk;
    if (!alone) settings.mission.robots = {m_robot};
    settings.mission.title = "Test desk";
    settings.memory = m_folder / "station.yaml";
    return must(Station::open(settings));
}

void Starts::start(Part part, const TestDomain& domain, Run& run) const {
    switch (part) {
        case Part::Robot:
            run.robot = robot(domain);
            break;
        case Part::Recorder:
            run.recorder = recorder(domain, run);
            break;
        case Part::Desk:
            run.station = desk(domain, run, m_settings.added);
            break;
        case Part::Adding:
            run.station.reset();  // as the window does: the station opens its mission again
            run.station = desk(domain, run, false);
            break;
    }
}

void Starts::look(Run& run) const {
    const LinkStatus link = run.station->robot(m_robot.name).link;
    std::erase_if(run.atDesk, [&](const std::string& topic) {
        return std::any_of(link.streams.begin(), link.streams.end(), [&](const StreamStatus& stream) {
            return stream.topic == topic && stream.samples > 0;
        });
    });
    const auto bag = BagReader::open(run.mission);
    if (!bag) return;
    std::erase_if(run.recorded, [&](const std::string& topic) {
        BagQuery query;
        query.topics = {topic};
        return (*bag)->read(query).next().has_value();
    });
}

bool Starts::receives(Run& run, std::string& course) const {
    const auto began = Clock::now();
    std::size_t before = 0;
    run.atDesk = run.recorded = steadyTopics(m_robot);
    return waitUntil(
        [&] {
            look(run);
            const std::size_t left = run.atDesk.size() + run.recorded.size();
            if (left != before) {
                const std::chrono::duration<double> seconds = Clock::now() - began;
                course += fmt::format(" {} at {:.2f} s", left, seconds.count());
                if (left > 0 && left <= 3)
                    course +=
                        fmt::format(" ({}{})", fmt::join(run.atDesk, " "), fmt::join(run.recorded, " "));
            }
            before = left;
            if (left > 0) std::this_thread::sleep_for(20ms);  // who looks all the time slows those that start
            return left == 0;
        },
        std::chrono::milliseconds(static_cast<int>(2e3 * m_settings.atMost)));
}

void Starts::once(int number) {
    const TestDomain domain;
    const auto meanwhile = m_settings.meanwhile ? m_settings.meanwhile(domain.number()) : nullptr;
    Run run;
    run.mission = m_folder / ("recorded" + std::to_string(number));
    run.desk = m_folder / ("desk" + std::to_string(number));
    for (const Part part : order()) {
        const std::chrono::milliseconds offset(std::uniform_int_distribution<int>(0, 500)(m_random));
        run.when += " " + std::to_string(offset.count()) + " ms " + Words[static_cast<std::size_t>(part)];
        std::this_thread::sleep_for(offset);  // what is tried is a start at this moment, whatever others do
        start(part, domain, run);
    }
    const auto says = [](const ChildProcess& process, const std::string& text) {
        return waitUntil([&] { return process.out().find(text) != std::string::npos; }, 60s);
    };
    ASSERT_TRUE(says(*run.robot, " is in ")) << run.robot->out();
    ASSERT_TRUE(says(*run.recorder, "recording domain")) << run.recorder->out();
    const auto began = Clock::now();
    std::string course;
    const bool all = receives(run, course);
    const double seconds = std::chrono::duration<double>(Clock::now() - began).count();
    m_seconds.push_back(seconds);
    EXPECT_TRUE(all && seconds < m_settings.atMost)
        << "start " << number << " (" << run.when << "): after " << seconds << " s; unheard:" << course
        << "; by the station: " << testing::PrintToString(run.atDesk)
        << ", by the recorder: " << testing::PrintToString(run.recorded) << "\n"
        << run.recorder->out();
    run.recorder->signal(SIGINT);
    EXPECT_EQ(run.recorder->wait(), 0) << run.recorder->out();
    run.robot->signal(SIGINT);
    EXPECT_EQ(run.robot->wait(), 0) << run.robot->out();
}

}  // namespace leitstand::test
