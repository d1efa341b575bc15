#include "tests/app/attack/besieged.h"

#include <algorithm>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "app/services/log/sequencer.h"
#include "core/event/event.h"
#include "core/event/stream_role.h"
#include "tests/support/attack.h"
#include "tests/support/resident_memory.h"
#include "tests/transport/screen/packets.h"
#include "transport/security/enclave.h"
#include "transport/security/keys.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr double MostMegabytes = 50.0;  // that an attack adds
constexpr double FullRate = 0.9;        // of what the robot says, which is less on a busy machine
constexpr std::uint64_t LeastRate = 5;  // samples a second of robots that live; 20 on an idle machine
const char* const Robots[] = {"kurt3d", "crawler"};

bool lives(pid_t process) {
    std::ifstream in(fmt::format("/proc/{}/stat", process));
    std::string number, name, state;
    in >> number >> name >> state;
    return in && state != "Z";
}

/// How many of @p times are in the second from @p from.
std::uint64_t countFrom(const std::vector<Time>& times, Time from) {
    return static_cast<std::uint64_t>(
        std::count_if(times.begin(), times.end(), [&](Time at) { return at >= from && at < from + 1s; }));
}

std::string odometryOf(const std::string& robot) {
    return "/" + robot + "/odom";
}

}  // namespace

std::vector<std::string> Besieged::with(std::vector<std::string> arguments,
                                        const std::string& enclave) const {
    const std::string domain = std::to_string(m_domain.number());
    arguments.insert(arguments.end(), {"--domain", domain, "--interface", "lo"});
    if (m_keys == Keys::All) {
        arguments.emplace_back("--keys");
        arguments.push_back((m_folder / "keys" / "enclaves" / enclave).string());
    }
    return arguments;
}

std::vector<std::string> Besieged::robotArguments(const std::string& kind) const {
    return with({kind, "--arena", "yellow", "--seed", "7"}, kind);
}

void Besieged::begin(Keys keys) {
    m_keys = keys;
    if (keys == Keys::All) {
        const auto made = createKeys(m_folder / "keys", {{KeyRole::Station, "desk", {}, false},
                                                         {KeyRole::Station, "other", {}, false},
                                                         {KeyRole::Viewer, "ear", {}, false},
                                                         {KeyRole::Viewer, "recorder", {}, false},
                                                         {KeyRole::Viewer, "watcher", {}, false},
                                                         {KeyRole::Robot, "kurt3d", {}, false},
                                                         {KeyRole::Robot, "crawler", {}, false}});
        ASSERT_TRUE(made.ok()) << made.error().text;
    }
    std::vector<RobotDescription> files;
    for (const char* robot : Robots) {
        files.push_back(must(readRobot(fmt::format("{}/resources/robots/{}.yaml", sourceFolder(), robot))));
        m_robots.push_back(std::make_unique<ChildProcess>(program("leitstand-robot"), robotArguments(robot)));
    }
    m_recorder = std::make_unique<ChildProcess>(
        program("leitstandctl"),
        with({"record", "--out", (m_folder / "recorded").string(), "--robot", "kurt3d", "--robot", "crawler"},
             "recorder"));
    StationSettings settings = settingsFor(files);
    settings.domain.interfaces = {"lo"};
    if (keys == Keys::All) settings.domain.keys = m_folder / "keys" / "enclaves" / "desk";
    StationListener listener;
    listener.onEvent = [this](const Event& event) {
        if (event.role != StreamRole::Odometry) return;
        const std::scoped_lock lock(m_heardMutex);
        m_received[event.robot].push_back(event.received);
    };
    m_station = must(Station::open(settings, std::move(listener)));
    m_attacker = std::make_unique<Attacker>(m_domain.number());
    for (const char* robot : Robots) {
        listen(robot);
        ASSERT_TRUE(m_inboxes[robot].waitFor(20, 60s)) << robot << drops();
    }
    ASSERT_TRUE(waitUntil([&] { return hearsAgain(); }, 60s)) << "starts take their time";
    ASSERT_TRUE(
        waitUntil([&] { return m_recorder->out().find("recording domain") != std::string::npos; }, 60s));
    for (const char* robot : Robots) {
        const std::string gotOne = fmt::format("{}: connected", robot);
        ASSERT_TRUE(waitUntil([&] { return m_recorder->out().find(gotOne) != std::string::npos; }, 60s))
            << m_recorder->out();
    }
    std::vector<std::string> network = {"--interface", "lo"};
    if (keys == Keys::All)
        network.insert(network.end(), {"--keys", (m_folder / "keys" / "enclaves" / "other").string()});
    m_other = std::make_unique<ListeningStation>(m_folder / "other", m_domain, network);
    ASSERT_TRUE(waitUntil(
        [&] {
            return m_other->receives({odometryOf("kurt3d"), odometryOf("crawler")});
        },
        60s));
    for (std::size_t i = 0; i < m_robots.size(); ++i) watch(Robots[i], m_robots[i]->id());
    watch("recorder", m_recorder->id());
    watch("station", m_other->id());
}

void Besieged::watch(const std::string& who, pid_t process) {
    m_watched.push_back({who, process, residentMegabytes(process)});
}

void Besieged::listen(const std::string& robot) {
    if (!m_node) {
        NodeSettings settings;
        settings.interfaces = {"lo"};
        settings.name = "watcher";
        if (m_keys == Keys::All)
            settings.security = must(securityFiles(m_folder / "keys" / "enclaves" / "watcher"));
        m_node = nodeIn(m_domain, settings);
    }
    m_listening.push_back(must(m_node->subscribe({odometryOf(robot), "nav_msgs/msg/Odometry", bestEffort(50)},
                                                 m_inboxes[robot].callback())));
}

std::string Besieged::drops() const {
    std::string text;
    for (const ScreenDrop& drop : m_node->dropped()) text += "; " + toString(drop);
    return text;
}

std::uint64_t Besieged::saidFrom(const std::string& robot, Time from) const {
    std::uint64_t first = 0, last = 0;
    for (const ReceivedSample& sample : m_inboxes.at(robot).samples()) {
        if (sample.event.received < from || sample.event.received >= from + 1s) continue;
        if (first == 0) first = sample.writerSequence;
        last = sample.writerSequence;
    }
    return first == 0 ? 0 : last - first + 1;
}

std::vector<RecordedPacket> Besieged::overheard(std::size_t packets) {
    NodeSettings settings;
    settings.domain = m_domain.number();
    settings.interfaces = {"lo"};
    settings.name = "ear";
    if (m_keys == Keys::All) settings.security = must(securityFiles(m_folder / "keys" / "enclaves" / "ear"));
    RecordingParticipant ear(settings, packets);
    for (const char* robot : Robots) {
        ear.listen(odometryOf(robot), bestEffort(), "nav_msgs/msg/Odometry");
        ear.listen(fmt::format("/{}/points", robot), reliable(10), "sensor_msgs/msg/PointCloud2");
        ear.listen(fmt::format("/{}/imu", robot), bestEffort(), "sensor_msgs/msg/Imu");
    }
    const auto began = std::chrono::steady_clock::now();
    EXPECT_TRUE(waitUntil([&] { return ear.arrived() >= packets; }, 60s)) << ear.arrived();
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    std::printf("screen: %.0f packets a second are heard of both robots\n", double(ear.arrived()) / seconds);
    EXPECT_TRUE(ear.gate().drops().empty()) << ear.gate().lastFault();
    return ear.packets();
}

void Besieged::crowd(int participants, int topics) {
    std::vector<std::unique_ptr<Attacker>> all;
    for (int i = 0; i < participants; ++i) {
        Attacker& one = *all.emplace_back(std::make_unique<Attacker>(m_domain.number()));
        one.announce(Packet(1'000 + i).announce(20, 0).bytes());
        for (int topic = 1; topic <= topics; ++topic) {
            const auto id = static_cast<screen::EntityId>(topic) << 8;
            one.announce(Packet(1'000 + i).announceEndpoint(id | 3, true, topic).bytes());
            one.announce(Packet(1'000 + i).announceEndpoint(id | 4, false, topic).bytes());
        }
    }
}

void Besieged::storm(Mutator& mutator, Mutation how, int count) {
    for (int i = 0; i < count; ++i) m_attacker->send(mutator.next(how));
}

bool Besieged::hearsAgain() {
    const auto heardFrom = [this](const std::string& robot, Time from) {
        const std::scoped_lock lock(m_heardMutex);
        return countFrom(m_received[robot], from);
    };
    return waitUntil(
        [&] {
            const Time from = stationTime() - 1s;
            return std::all_of(std::begin(Robots), std::end(Robots), [&](const char* robot) {
                const std::uint64_t reported = saidFrom(robot, from);
                return reported >= LeastRate && double(heardFrom(robot, from)) >= FullRate * double(reported);
            });
        },
        5s);
}

void Besieged::expectUnharmed(const std::string& what, std::uint64_t packets) {
    m_proofs.push_back({what, stationTime()});
    for (const Watched& one : m_watched) EXPECT_TRUE(lives(one.process)) << one.who << " after " << what;
    const bool receives = hearsAgain();
    EXPECT_TRUE(receives) << what;
    double more = 0.0;
    for (const Watched& one : m_watched) {
        const double grown = residentMegabytes(one.process) - one.megabytes;
        std::printf("%s: %.0f MB more\n", one.who.c_str(), grown);
        EXPECT_LT(grown, MostMegabytes) << one.who << " after " << what;
        more = std::max(more, grown);
    }
    tellAttack(
        "wire", what + (m_keys == Keys::All ? ", with keys" : ""), packets,
        fmt::format("{}, {:.0f} MB more at most",
                    receives ? "all live, robots heard at full rate within 5 s" : "ROBOTS NOT HEARD", more));
}

void Besieged::endAndExpectWhole() {
    // What is looked for in the log has to be in it.
    ASSERT_TRUE(waitUntil([&] { return stationTime() > m_proofs.back().end + 5s; }));
    m_recorder->signal(SIGTERM);
    EXPECT_EQ(m_recorder->wait(), 0) << m_recorder->out();
    const auto bag = must(BagReader::open(m_folder / "recorded"));
    EXPECT_TRUE(bag->problems().empty()) << bag->problems().front();
    for (const char* robot : Robots) {
        BagQuery query;
        query.topics = {odometryOf(robot)};
        BagCursor cursor = bag->read(query);
        std::vector<Time> gotOne;
        while (const auto event = cursor.next()) gotOne.push_back(event->received);
        for (const Proof& proof : m_proofs) {
            bool full = false;
            for (auto from = proof.end; from < proof.end + 4s; from += 250ms) {
                const std::uint64_t reported = saidFrom(robot, from);
                full = full || (reported >= LeastRate &&
                                double(countFrom(gotOne, from)) >= FullRate * double(reported));
            }
            EXPECT_TRUE(full) << proof.what << ", recorded of " << robot << "; " << m_recorder->out();
        }
    }
    for (const auto& robot : m_robots) robot->signal(SIGTERM);
    for (const auto& robot : m_robots) EXPECT_EQ(robot->wait(), 0);
}

}  // namespace leitstand::test
