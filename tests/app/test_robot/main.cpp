#include <atomic>
#include <csignal>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "tests/app/test_robot/test_robot.h"

namespace {
std::atomic<bool> stopped = false;
}

int main(int argc, char** argv) {
    CLI::App app("Says scans and odometry over DDS as a robot would", "leitstand-test-robot");
    leitstand::test::TestRobotSettings settings;
    app.add_option("--domain", settings.domain)->required();
    app.add_option("--name", settings.name);
    app.add_option("--scans", settings.scans, "Folder of uos scans; none: generated rooms");
    app.add_option("--slices", settings.slices, "Parts that each sweep is cut into");
    app.add_option("--keys", settings.keys, "Folder of its identity");
    app.add_option("--pause", settings.pauseSeconds, "Seconds between clouds");
    app.add_option("--wait-for", settings.waitForReaders,
                   "Readers of the clouds to wait for before the first");
    CLI11_PARSE(app, argc, argv);
    std::signal(SIGTERM, [](int) { stopped = true; });
    std::signal(SIGINT, [](int) { stopped = true; });
    const auto reported = leitstand::test::runTestRobot(settings, stopped);
    if (!reported) std::fprintf(stderr, "%s\n", reported.error().text.c_str());
    return reported ? 0 : 1;
}
