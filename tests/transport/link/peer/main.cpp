// control_peer robot DOMAIN
//     a robot "kurt3d"; says "moves", "rests", "stopped" and "free" on change
// control_peer station DOMAIN ID TERM SPEED
//     a station that holds the grant of TERM from the start and drives
// control_peer listen DOMAIN TOPIC TYPE
//     a reliable reader; says "heard" once
// control_peer pinged DOMAIN AHEAD
//     a robot "kurt3d" that says odometry and answers pings, with a clock that is so many seconds ahead
// All run until they are killed. CLOCK_AHEAD: seconds that their clock is ahead (clock_shift.cpp).
#include <cstdio>
#include <string>
#include <thread>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "tests/transport/link/control_robot.h"
#include "tests/transport/link/control_station.h"
#include "tests/transport/link/link_robot.h"
#include "transport/convert/decode.h"

namespace {

using namespace leitstand;
using namespace leitstand::test;

void publish(const char* word) {
    std::puts(word);
    std::fflush(stdout);
}

[[noreturn]] void waitForTheEnd() {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

[[noreturn]] void beRobot(Node& node) {
    ControlRobot robot(node, drivenRobot());
    publish("ready");
    bool moved = false, stopped = false;
    for (;;) {
        const bool moves = robot.speed() != 0.0, stops = robot.commands().isStopped();
        if (moves != moved) publish(moves ? "moves" : "rests");
        if (stops != stopped) publish(stops ? "stopped" : "free");
        moved = moves;
        stopped = stops;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

[[noreturn]] void beStation(Node& node, const std::string& id, const std::string& term, double speed) {
    ControlStation station(node, drivenRobot(), {id, "Peer", {{driveGrant("kurt3d"), std::stoull(term)}}});
    publish("ready");
    const StreamDescription odometry = *drivenRobot().stream(StreamRole::Odometry);
    std::atomic<bool> moves = false;
    const auto listening =
        must(node.subscribe({odometry.topic, odometry.type, odometry.qos}, [&](const ReceivedSample& sample) {
            moves = must(decode(sample.event, odometry)).get<OdometrySample>().linear.x() == speed;
        }));
    if (station.driveUntil(speed, [&] { return moves.load(); })) publish("drives");
    waitForTheEnd();
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 2) return 2;
    if (words[0] == "pinged" && words.size() == 3) {
        LinkRobot robot(std::stoi(words[1]), pingableRobot());
        robot.setAhead(std::chrono::seconds(std::stoi(words[2])));
        waitForTheEnd();
    }
    NodeSettings settings;
    settings.domain = std::stoi(words[1]);
    const auto node = Node::create(settings);
    if (!node) return std::puts(node.error().text.c_str()), 1;
    if (words[0] == "robot") beRobot(**node);
    if (words[0] == "station" && words.size() == 5)
        beStation(**node, words[2], words[3], std::stod(words[4]));
    if (words[0] == "listen" && words.size() == 4) {
        std::atomic<bool> received = false;
        const auto reader = must((*node)->subscribe({words[2], words[3], Qos{}}, [&](const ReceivedSample&) {
            if (!received.exchange(true)) publish("heard");
        }));
        waitForTheEnd();
    }
    return 2;
}
