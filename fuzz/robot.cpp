#include <string>

#include "core/io/robot/robot_file.h"
#include "core/robot/footprint.h"
#include "fuzz/input_file.h"

/// A robot's file. What was read keeps what the rest of the program relies on, and can be written and read
/// again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const auto robot = parseRobot({reinterpret_cast<const char*>(data), size}, "robot.yaml");
    if (!robot) {
        fuzz::require(robot.error().text.starts_with("robot.yaml:"), "an error that names its file");
        fuzz::require(robot.error().text.size() < 100'000, "errors that can be read");
        return 0;
    }
    fuzz::require(!robot->name.empty() && robot->letter.size() == 1, "a name and a letter");
    fuzz::require(footprintProblem(robot->footprint).empty(), "an outline");
    fuzz::require(signedArea(robot->footprint) > 0.0, "an outline that goes counter-clockwise");
    fuzz::require(robot->maxSpeed > 0.0 && robot->maxTurnRate > 0.0 && robot->height > 0.0, "a body");
    for (const StreamDescription& stream : robot->streams) {
        fuzz::require(stream.topic.starts_with('/'), "a topic");
        fuzz::require(stream.sensor.empty() || robot->sensors.contains(stream.sensor), "a known sensor");
    }
    const auto again = parseRobot(writeRobot(*robot), "again");
    fuzz::require(again.ok(), "a file that can be read again");
    fuzz::require(again->streams == robot->streams, "the same streams");
    fuzz::require(again->title == robot->title && again->bindings == robot->bindings, "the same texts");
    return 0;
}
