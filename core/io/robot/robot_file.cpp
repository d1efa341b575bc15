#include "core/io/robot/robot_file.h"

#include <algorithm>
#include <fstream>

#include "core/base/words.h"
#include "core/io/robot/joint_reader.h"
#include "core/io/robot/robot_keys.h"
#include "core/io/robot/robot_names.h"
#include "core/io/robot/service_reader.h"
#include "core/io/robot/stream_reader.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"
#include "core/robot/default_body.h"
#include "core/robot/footprint.h"

namespace leitstand {
namespace {

using detail::shown;
using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;

constexpr double LargestSize = 10.0;  ///< of robots and sensor positions [m]; larger values are millimetres

void readIdentity(const YamlFields& fields, RobotDescription& robot) {
    std::string name, letter;
    if (!fields.has("name") || fields.text("name", name)) {
        if (!detail::isName(name) || name == "leitstand") {
            fields.fail(
                "name",
                leitstand::fill(
                    translate(
                        "leitstand::Error",
                        "expected a name as in topics (letters, digits and _, not leitstand), found {}"),
                    fields.has("name") ? shown(name) : translate("leitstand::Error", "nothing")));
        } else {
            robot.name = name;
        }
    }
    if (!fields.has("letter") || fields.text("letter", letter)) {
        if (letter.size() != 1 || letter.front() < 'A' || letter.front() > 'Z') {
            fields.fail("letter",
                        leitstand::fill(
                            translate("leitstand::Error", "expected one capital letter, found {}"),
                            fields.has("letter") ? shown(letter) : translate("leitstand::Error", "nothing")));
        } else {
            robot.letter = letter;
        }
    }
    robot.title = robot.name;
    fields.text("title", robot.title);
}

/// Reads a frame such as "base_link" or "kurt3d/base_link".
void readFrame(const YamlFields& fields, const char* key, std::string& frame) {
    std::string found = frame;
    if (!fields.text(key, found)) return;
    if (found.front() == '/' || found.find(' ') != std::string::npos) {
        fields.fail(key, leitstand::fill(translate("leitstand::Error",
                                                   "expected a frame such as base_link, without a slash "
                                                   "before it and without blanks, found {}"),
                                         shown(found)));
    } else {
        frame = found;
    }
}

void readFrames(const YamlPlace& place, RobotDescription& robot, YamlErrors& errors) {
    const YamlFields fields(place, detail::FrameKeys, errors);
    readFrame(fields, "base", robot.baseFrame);
    readFrame(fields, "odom", robot.odomFrame);
    fields.choice("prefix", robot.tfPrefix, detail::prefixWords());
}

void readFootprint(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("footprint")) return;
    if (!fields.at("footprint").value.IsSequence()) {
        fields.fail("footprint",
                    leitstand::fill(translate("leitstand::Error", "expected a list of corners, found {}"),
                                    shown(fields.at("footprint").value)));
        return;
    }
    std::vector<Eigen::Vector2d> corners;
    const auto places = fields.list("footprint");
    for (const YamlPlace& place : places) {
        Eigen::Vector2d corner;
        const bool right = place.value.IsSequence() && place.value.size() == 2 &&
                           detail::isNumber(place.value[0], corner.x()) &&
                           detail::isNumber(place.value[1], corner.y()) &&
                           corner.cwiseAbs().maxCoeff() <= LargestSize;
        if (right) {
            corners.push_back(corner);
        } else {
            errors.add(place.line, place.path,
                       leitstand::fill(
                           translate("leitstand::Error", "expected [x, y], each from {} to {} m, found {}"),
                           -LargestSize, LargestSize, shown(place.value)));
        }
    }
    if (corners.size() < places.size()) return;
    if (const std::string problem = footprintProblem(corners); !problem.empty()) {
        fields.fail("footprint", problem);
        return;
    }
    if (signedArea(corners) < 0.0) std::reverse(corners.begin(), corners.end());
    robot.footprint = std::move(corners);
}

void readLimits(const YamlPlace& place, RobotDescription& robot, YamlErrors& errors) {
    const YamlFields fields(place, detail::LimitKeys, errors);
    const auto angle = [&fields](const char* key, double& radians, double most, const char* unit) {
        double value = inDegrees(radians);
        if (fields.has(key) && fields.number(key, value, 1.0, most, unit)) radians = degrees(value);
    };
    angle("roll", robot.maxRoll, 180.0, " degrees");
    angle("pitch", robot.maxPitch, 180.0, " degrees");
    angle("turn_rate", robot.maxTurnRate, 720.0, " degrees/s");
    fields.number("speed", robot.maxSpeed, 0.01, 20.0, " m/s");
    angle("climb", robot.maxClimb, 60.0, " degrees");
    fields.number("step", robot.maxStep, 0.01, 1.0, " m");
}

PanTiltMount panTiltOf(const YamlPlace& place, const std::string& sensor, YamlErrors& errors) {
    const YamlFields fields(place, detail::PanTiltKeys, errors);
    PanTiltMount mount;
    mount.unit = sensor;
    fields.text("unit", mount.unit);
    const auto angle = [&fields](const char* key, double& radians) {
        double value = inDegrees(radians);
        if (fields.has(key) && fields.number(key, value, 0.0, 180.0, " degrees")) radians = degrees(value);
    };
    angle("pan", mount.pan);
    angle("up", mount.up);
    angle("down", mount.down);
    return mount;
}

ScannerCorrection correctionOf(const YamlPlace& place, YamlErrors& errors) {
    using Correction = ScannerCorrection;
    const YamlFields fields(place, detail::CorrectionKeys, errors);
    Correction correction;
    fields.number("range", correction.range, -Correction::MostRange, Correction::MostRange, " m");
    const auto angle = [&](const char* key, double most, double& radians) {
        double value = 0.0;
        if (fields.has(key) && fields.number(key, value, -inDegrees(most), inDegrees(most), " degrees"))
            radians = degrees(value);
    };
    angle("roll", Correction::MostLean, correction.roll);
    angle("pitch", Correction::MostLean, correction.pitch);
    fields.number("x", correction.x, -Correction::MostShift, Correction::MostShift, " m");
    fields.number("y", correction.y, -Correction::MostShift, Correction::MostShift, " m");
    angle("yaw", Correction::MostTurn, correction.yaw);
    fields.number("clock", correction.clock, -Correction::MostClock, Correction::MostClock, " s");
    return correction;
}

void readSensors(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("sensors")) return;
    const YamlFields sensors(fields.at("sensors"), errors);
    for (const auto& [name, place] : sensors.entries()) {
        const YamlFields one(place, detail::SensorKeys, errors);
        SensorDescription sensor;
        sensor.frame = name;
        readFrame(one, "frame", sensor.frame);
        std::vector<double> position(3, 0.0), rotation(3, 0.0);
        one.numbers("position", position, 3, LargestSize, " m");
        one.numbers("rotation", rotation, 3, 360.0, " degrees");
        sensor.sensorInBase = poseFrom({position[0], position[1], position[2]}, degrees(rotation[0]),
                                       degrees(rotation[1]), degrees(rotation[2]));
        one.choice("motion", sensor.motion, detail::motionWords());
        if (one.has("pan_tilt")) sensor.panTilt = panTiltOf(one.at("pan_tilt"), name, errors);
        if (one.has("correction")) sensor.correction = correctionOf(one.at("correction"), errors);
        robot.sensors.emplace(name, sensor);
    }
}

void readBindings(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("bindings")) return;
    const YamlFields bindings(fields.at("bindings"), errors);
    std::map<std::string, std::string> actions;
    for (const auto& entry : bindings.entries()) {
        std::string control;
        if (!bindings.text(entry.first, control)) continue;
        const auto [other, added] = actions.emplace(control, entry.first);
        if (!added)
            bindings.fail(
                entry.first,
                leitstand::fill(
                    translate("leitstand::Error",
                              "expected a key or pad control of its own, found {}, which is that of {}"),
                    shown(control), other->second));
        robot.bindings.emplace(entry.first, control);
    }
}

void readPackages(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    constexpr std::size_t Most = 32, Longest = 1024;
    if (!fields.has("packages")) return;
    for (const YamlPlace& place : fields.list("packages")) {
        const std::string folder = place.value.IsScalar() ? place.value.Scalar() : std::string();
        if (!folder.empty() && folder.size() <= Longest && robot.packages.size() < Most) {
            robot.packages.push_back(folder);
            continue;
        }
        errors.add(
            place.line, place.path,
            leitstand::fill(translate("leitstand::Error", "expected a folder, at most {} of them, found {}"),
                            Most, shown(place.value)));
    }
}

void readLinkLoss(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("link_loss")) return;
    const YamlFields rules(fields.at("link_loss"), errors);
    for (const auto& entry : rules.entries()) {
        LinkLossRule rule = LinkLossRule::Stop;
        if (!rules.choice(entry.first, rule, detail::linkLossWords())) continue;
        if (entry.first == "teleoperation" && rule != LinkLossRule::Stop)
            rules.fail(entry.first, leitstand::fill(translate("leitstand::Error",
                                                              "expected stop, since nobody drives, found {}"),
                                                    shown(toString(rule))));
        robot.linkLoss.emplace(entry.first, rule);
    }
}

RobotDescription readAll(const YAML::Node& root, YamlErrors& errors) {
    const YamlFields fields({root, "", 1}, detail::RobotKeys, errors);
    RobotDescription robot;
    fillBody(robot);
    if (!root.IsMap()) return robot;
    readIdentity(fields, robot);
    fields.choice("drive", robot.drive, detail::driveWords());
    if (fields.has("frames")) readFrames(fields.at("frames"), robot, errors);
    readFootprint(fields, robot, errors);
    fields.number("height", robot.height, 0.01, LargestSize, " m");
    fields.flag("refine_turns", robot.refineTurns);
    if (fields.has("limits")) readLimits(fields.at("limits"), robot, errors);
    readSensors(fields, robot, errors);
    detail::readJointGroups(fields, robot, errors);
    detail::readStreams(fields, robot, errors);
    detail::checkJointCommands(fields, robot);
    detail::readServices(fields, robot, errors);
    readBindings(fields, robot, errors);
    readPackages(fields, robot, errors);
    readLinkLoss(fields, robot, errors);
    return robot;
}

}  // namespace

Result<RobotDescription> parseRobot(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors(name);
    try {
        RobotDescription robot = readAll(*root, errors);
        if (errors.empty()) return robot;
    } catch (const YAML::Exception& problem) {
        errors.add(std::max(0, problem.mark.line) + 1, {},
                   leitstand::fill(translate("leitstand::Error", "expected YAML, found a mistake: {}"),
                                   problem.msg));
    }
    return errors.error();
}

Result<RobotDescription> readRobot(const std::filesystem::path& file) {
    std::error_code problem;
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file, problem))
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a robot's file, found none that can be read"),
            file.string())};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    auto read = parseRobot(text, file.string());
    if (!read) return read;
    RobotDescription robot = std::move(read).value();
    robot.file = file.string();
    // The mission's copy of the file stands elsewhere, and means the same folders.
    for (std::string& folder : robot.packages)
        folder =
            std::filesystem::absolute(file, problem).parent_path().append(folder).lexically_normal().string();
    return robot;
}

}  // namespace leitstand
