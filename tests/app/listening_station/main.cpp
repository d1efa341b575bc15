// listening_station FOLDER DOMAIN [--interface NAME] [--keys ENCLAVE] [--explore] [--thin MEGABITS]
// [ROBOT...]
//     an operator's station on shipped robots (kurt3d and crawler) that records into FOLDER. Says twice a
//     second for each robot "link ROBOT STATE" and for each of its steady streams "stream TOPIC ARRIVED LOST
//     RATE", ends with "told". --explore: it asks both to explore. --thin: the link is thin, and has so much.
// Runs until SIGTERM.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "app/services/station/station.h"
#include "app/services/station/station_streams.h"
#include "core/event/status_samples.h"
#include "core/io/robot/robot_file.h"
#include "core/mission/state/mission_state.h"
#include "tests/support/places.h"

namespace {

using namespace leitstand;
using namespace std::chrono_literals;

volatile std::sig_atomic_t ended = 0;

struct Arguments {
    std::filesystem::path folder;
    int domain = 0;
    std::vector<std::string> interfaces = {};  ///< none: all
    std::filesystem::path keys = {};           ///< none: an open domain
    bool explore = false;
    double thin = 0.0;  ///< [Mbit/s]; 0: the link is not thin
    std::vector<std::string> robots = {};
};

Arguments parse(const std::vector<std::string>& words) {
    Arguments all{words.at(0), std::stoi(words.at(1))};
    for (std::size_t i = 2; i < words.size(); ++i) {
        if (words[i] == "--explore") {
            all.explore = true;
        } else if (words[i] == "--interface") {
            all.interfaces = {words.at(++i)};
        } else if (words[i] == "--keys") {
            all.keys = words.at(++i);
        } else if (words[i] == "--thin") {
            all.thin = std::stod(words.at(++i));
        } else {
            all.robots.push_back(words[i]);
        }
    }
    if (all.robots.empty()) all.robots = {"kurt3d", "crawler"};
    return all;
}

StationSettings settingsFor(const Arguments& arguments) {
    StationSettings settings;
    settings.domain.domain = arguments.domain;
    settings.domain.interfaces = arguments.interfaces;
    settings.domain.keys = arguments.keys;
    settings.mission.folder = arguments.folder / "mission";
    for (const std::string& name : arguments.robots) {
        settings.mission.robots.push_back(
            readRobot(test::sourceFolder() + "/resources/robots/" + name + ".yaml").value());
    }
    settings.mission.title = "Test desk";
    settings.mission.version = "test";
    settings.memory = arguments.folder / "station.yaml";
    return settings;
}

bool explores(const Station& station, const std::string& robot) {
    const auto state = station.mission();
    const auto found = state->robots.find(robot);
    return found != state->robots.end() && found->second->mode && found->second->mode->sample.autonomous;
}

void print(const LinkStatus& link) {
    std::printf("link %s %s\n", link.robot.c_str(), toString(link.state).c_str());
    for (const StreamStatus& stream : link.streams) {
        if (!stream.steady) continue;
        std::printf("stream %s %llu %llu %.1f\n", stream.topic.c_str(),
                    static_cast<unsigned long long>(stream.samples),
                    static_cast<unsigned long long>(stream.lost), stream.rate);
    }
}

}  // namespace

int main(int count, char** words) {
    const Arguments arguments = parse({words + 1, words + count});
    std::signal(SIGTERM, [](int) { ended = 1; });
    auto opened = Station::open(settingsFor(arguments));
    if (!opened) {
        std::fprintf(stderr, "%s\n", opened.error().text.c_str());
        return 1;
    }
    Station& station = **opened;
    if (arguments.thin > 0.0) {
        station.streams().setThin({.budget = arguments.thin});
        station.streams().thin({}, true);
    }
    while (ended == 0) {
        for (const std::string& robot : arguments.robots) {
            if (arguments.explore && !station.robot(robot).grant.mine) station.requestGrant(robot);
            if (arguments.explore && station.robot(robot).grant.mine && !explores(station, robot))
                (void)station.setMode(robot, "explore");
            print(station.robot(robot).link);
        }
        std::puts("told");
        std::fflush(stdout);
        for (int i = 0; i < 50 && ended == 0; ++i) std::this_thread::sleep_for(10ms);
    }
    return 0;
}
