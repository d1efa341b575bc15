#include <string>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/rotation/euler_angles.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/robot_names.h"
#include "core/robot/default_body.h"
#include "core/robot/streams/stream_defaults.h"

namespace leitstand {
namespace {

/// Returns the shortest text that reads back as @p value.
std::string number(double value) {
    return fmt::format("{}", value);
}

/// Returns degrees for people: 25 is not written as 24.999999999999996.
std::string angle(double radians) {
    return fmt::format("{:.12g}", inDegrees(radians));
}

void list(YAML::Emitter& out, const char* key, const std::vector<std::string>& values) {
    out << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const std::string& value : values) out << value;
    out << YAML::EndSeq;
}

void entry(YAML::Emitter& out, const char* key, const std::string& value) {
    out << YAML::Key << key << YAML::Value << value;
}

void writeSensor(YAML::Emitter& out, const std::string& name, const SensorDescription& sensor) {
    const Eigen::Vector3d position = sensor.sensorInBase.translation();
    const Eigen::Vector3d turn = rollPitchYawOf(sensor.sensorInBase);
    out << YAML::Key << name << YAML::Value << YAML::BeginMap;
    entry(out, "frame", sensor.frame);
    list(out, "position", {number(position.x()), number(position.y()), number(position.z())});
    list(out, "rotation", {angle(turn.x()), angle(turn.y()), angle(turn.z())});
    if (sensor.motion != SensorMotion::Unknown) entry(out, "motion", toString(sensor.motion));
    if (sensor.panTilt) {
        out << YAML::Key << "pan_tilt" << YAML::Value << YAML::Flow << YAML::BeginMap;
        entry(out, "unit", sensor.panTilt->unit);
        entry(out, "pan", angle(sensor.panTilt->pan));
        entry(out, "up", angle(sensor.panTilt->up));
        entry(out, "down", angle(sensor.panTilt->down));
        out << YAML::EndMap;
    }
    if (!sensor.correction.isNone()) {
        out << YAML::Key << "correction" << YAML::Value << YAML::Flow << YAML::BeginMap;
        const ScannerCorrection& correction = sensor.correction;
        entry(out, "range", number(correction.range));
        entry(out, "roll", angle(correction.roll));
        entry(out, "pitch", angle(correction.pitch));
        if (correction.x != 0.0) entry(out, "x", number(correction.x));
        if (correction.y != 0.0) entry(out, "y", number(correction.y));
        if (correction.yaw != 0.0) entry(out, "yaw", angle(correction.yaw));
        if (correction.clock != 0.0) entry(out, "clock", number(correction.clock));
        out << YAML::EndMap;
    }
    out << YAML::EndMap;
}

void writeQos(YAML::Emitter& out, const Qos& qos, const Qos& usual) {
    out << YAML::Key << "qos" << YAML::Value << YAML::Flow << YAML::BeginMap;
    entry(out, "reliability", detail::wordFor(detail::reliabilityWords(), qos.reliability));
    entry(out, "durability", detail::wordFor(detail::durabilityWords(), qos.durability));
    entry(out, "depth", std::to_string(qos.depth));
    if (qos.lifespan > 0.0 || usual.lifespan > 0.0) entry(out, "lifespan", number(qos.lifespan));
    if (qos.deadline > 0.0) entry(out, "deadline", number(qos.deadline));
    out << YAML::EndMap;
}

void writeReadings(YAML::Emitter& out, const std::vector<ReadingDescription>& readings) {
    out << YAML::Key << "readings" << YAML::Value << YAML::BeginSeq;
    for (const ReadingDescription& reading : readings) {
        const auto limit = [&](const char* key, const std::optional<double>& value) {
            if (value) entry(out, key, number(*value));
        };
        out << YAML::Flow << YAML::BeginMap;
        entry(out, "field", reading.field);
        entry(out, "title", reading.title);
        if (!reading.unit.empty()) entry(out, "unit", reading.unit);
        if (reading.scale != 1.0) entry(out, "scale", number(reading.scale));
        if (reading.offset != 0.0) entry(out, "offset", number(reading.offset));
        if (reading.decimals) entry(out, "decimals", std::to_string(*reading.decimals));
        limit("low", reading.limits.low);
        limit("low_act", reading.limits.lowAct);
        limit("high", reading.limits.high);
        limit("high_act", reading.limits.highAct);
        out << YAML::EndMap;
    }
    out << YAML::EndSeq;
}

void writeStream(YAML::Emitter& out, const StreamDescription& stream, const std::string& robot) {
    const StreamDescription usual = defaultStream(stream.role, robot, stream.sensor);
    out << YAML::BeginMap;
    entry(out, "role", detail::wordFor(detail::roleWords(), stream.role));
    if (!stream.sensor.empty()) entry(out, "sensor", stream.sensor);
    entry(out, "topic", stream.topic);
    entry(out, "type", stream.type);
    writeQos(out, stream.qos, usual.qos);
    if (stream.stamp != usual.stamp) entry(out, "stamp", detail::wordFor(detail::stampWords(), stream.stamp));
    if (stream.role == StreamRole::Thermal) {
        out << YAML::Key << "thermal" << YAML::Value << YAML::Flow << YAML::BeginMap;
        entry(out, "scale", number(stream.thermal.scale));
        entry(out, "offset", number(stream.thermal.offset));
        entry(out, "measured", stream.thermal.measured ? "true" : "false");
        out << YAML::EndMap;
    }
    if (!stream.group.empty()) entry(out, "group", stream.group);
    if (stream.hardwareId != usual.hardwareId) entry(out, "hardware_id", stream.hardwareId);
    if (!stream.record) entry(out, "record", "false");
    if (stream.maps) entry(out, "maps", "true");
    if (stream.readings != usualReadings(stream.type)) writeReadings(out, stream.readings);
    out << YAML::EndMap;
}

void writeServices(YAML::Emitter& out, const std::vector<ServiceDescription>& services) {
    if (services.empty()) return;
    out << YAML::Key << "services" << YAML::Value << YAML::BeginSeq;
    for (const ServiceDescription& service : services) {
        out << YAML::Flow << YAML::BeginMap;
        entry(out, "name", service.name);
        entry(out, "type", service.type);
        if (!service.title.empty()) entry(out, "title", service.title);
        if (service.stop) entry(out, "stop", *service.stop ? "true" : "false");
        out << YAML::EndMap;
    }
    out << YAML::EndSeq;
}

/// Returns @p position as files have it: in degrees, or in metres.
std::string position(const MovedJoint& joint, double value) {
    return joint.type == JointType::Revolute ? angle(value) : number(value);
}

void writeJoint(YAML::Emitter& out, const MovedJoint& joint) {
    out << YAML::Flow << YAML::BeginMap;
    entry(out, "name", joint.name);
    if (joint.type != JointType::Revolute) entry(out, "type", toString(joint.type));
    if (joint.lower) entry(out, "lower", position(joint, *joint.lower));
    if (joint.upper) entry(out, "upper", position(joint, *joint.upper));
    entry(out, "rate", position(joint, joint.rate));
    if (joint.reversed) entry(out, "reversed", "true");
    if (joint.link) {
        out << YAML::Key << "link" << YAML::Value << YAML::Flow << YAML::BeginMap;
        list(out, "at", {number(joint.link->place.x()), number(joint.link->place.y())});
        entry(out, "length", number(joint.link->length));
        if (joint.link->zero != 0.0) entry(out, "zero", angle(joint.link->zero));
        if (!joint.link->parent.empty()) entry(out, "parent", joint.link->parent);
        out << YAML::EndMap;
    }
    out << YAML::EndMap;
}

void writeJointGroup(YAML::Emitter& out, const JointGroup& group) {
    out << YAML::BeginMap;
    entry(out, "name", group.name);
    entry(out, "title", group.title);
    entry(out, "command", toString(group.mode));
    out << YAML::Key << "joints" << YAML::Value << YAML::BeginSeq;
    for (const MovedJoint& joint : group.joints) writeJoint(out, joint);
    out << YAML::EndSeq << YAML::Key << "axes" << YAML::Value << YAML::BeginSeq;
    for (const JointAxis& axis : group.axes) {
        std::vector<std::string> names;
        for (const std::size_t joint : axis.joints) names.push_back(group.joints[joint].name);
        out << YAML::Flow << YAML::BeginMap;
        entry(out, "title", axis.title);
        list(out, "joints", names);
        out << YAML::EndMap;
    }
    out << YAML::EndSeq;
    if (!group.presets.empty()) {
        out << YAML::Key << "presets" << YAML::Value << YAML::BeginSeq;
        for (const JointPreset& preset : group.presets) {
            std::vector<std::string> positions;
            for (std::size_t i = 0; i < preset.positions.size(); ++i)
                positions.push_back(position(group.joints[i], preset.positions[i]));
            out << YAML::Flow << YAML::BeginMap;
            entry(out, "title", preset.title);
            list(out, "positions", positions);
            out << YAML::EndMap;
        }
        out << YAML::EndSeq;
    }
    out << YAML::EndMap;
}

void writeJointGroups(YAML::Emitter& out, const std::vector<JointGroup>& groups) {
    if (groups.empty()) return;
    out << YAML::Key << "joint_groups" << YAML::Value << YAML::BeginSeq;
    for (const JointGroup& group : groups) writeJointGroup(out, group);
    out << YAML::EndSeq;
}

void writeBody(YAML::Emitter& out, const RobotDescription& robot) {
    out << YAML::Key << "footprint" << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const Eigen::Vector2d& corner : robot.footprint) {
        out << YAML::Flow << YAML::BeginSeq << number(corner.x()) << number(corner.y()) << YAML::EndSeq;
    }
    out << YAML::EndSeq << YAML::Comment("base frame, counter-clockwise [m]");
    out << YAML::Key << "height" << YAML::Value << number(robot.height) << YAML::Comment("[m]");
    out << YAML::Key << "limits" << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "roll" << YAML::Value << angle(robot.maxRoll)
        << YAML::Comment("tips over beyond [degrees]");
    out << YAML::Key << "pitch" << YAML::Value << angle(robot.maxPitch);
    out << YAML::Key << "speed" << YAML::Value << number(robot.maxSpeed) << YAML::Comment("[m/s]");
    out << YAML::Key << "turn_rate" << YAML::Value << angle(robot.maxTurnRate)
        << YAML::Comment("[degrees/s]");
    if (robot.maxClimb > 0.0)
        out << YAML::Key << "climb" << YAML::Value << angle(robot.maxClimb) << YAML::Comment("[degrees]");
    if (robot.maxStep > 0.0)
        out << YAML::Key << "step" << YAML::Value << number(robot.maxStep) << YAML::Comment("[m]");
    out << YAML::EndMap;
}

void writeMaps(YAML::Emitter& out, const RobotDescription& robot) {
    if (!robot.packages.empty()) list(out, "packages", robot.packages);
    if (robot.refineTurns) entry(out, "refine_turns", "true");
    if (!robot.bindings.empty()) {
        out << YAML::Key << "bindings" << YAML::Value << YAML::BeginMap;
        for (const auto& [action, control] : robot.bindings) entry(out, action.c_str(), control);
        out << YAML::EndMap;
    }
    if (!robot.linkLoss.empty()) {
        out << YAML::Key << "link_loss" << YAML::Value << YAML::BeginMap;
        for (const auto& [mode, rule] : robot.linkLoss) {
            entry(out, mode.c_str(), detail::wordFor(detail::linkLossWords(), rule));
        }
        out << YAML::EndMap;
    }
}

}  // namespace

std::string writeRobot(const RobotDescription& given) {
    RobotDescription robot = given;
    fillBody(robot);  // a guessed robot has no body yet
    // Adds an entry for a camera without a known place, so that people can write it there.
    for (const StreamDescription& stream : robot.streams) {
        if (!stream.sensor.empty())
            robot.sensors.try_emplace(stream.sensor, SensorDescription{.frame = stream.sensor});
    }
    YAML::Emitter out;
    out << YAML::Comment("A robot of Leitstand; docs/robots.md tells every key.") << YAML::BeginMap;
    entry(out, "letter", robot.letter);
    entry(out, "name", robot.name);
    entry(out, "title", robot.title);
    entry(out, "drive", detail::wordFor(detail::driveWords(), robot.drive));
    out << YAML::Key << "frames" << YAML::Value << YAML::BeginMap;
    entry(out, "base", robot.baseFrame);
    entry(out, "odom", robot.odomFrame);
    entry(out, "prefix", detail::wordFor(detail::prefixWords(), robot.tfPrefix));
    out << YAML::EndMap;
    writeBody(out, robot);
    if (!robot.sensors.empty()) {
        out << YAML::Key << "sensors"
            << YAML::Comment("frame_id, place in the base frame [m], roll pitch yaw [degrees]") << YAML::Value
            << YAML::BeginMap;
        for (const auto& [name, sensor] : robot.sensors) writeSensor(out, name, sensor);
        out << YAML::EndMap;
    }
    out << YAML::Key << "streams" << YAML::Value << YAML::BeginSeq;
    for (const StreamDescription& stream : robot.streams) writeStream(out, stream, robot.name);
    out << YAML::EndSeq;
    writeServices(out, robot.services);
    writeJointGroups(out, robot.jointGroups);
    writeMaps(out, robot);
    out << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

}  // namespace leitstand
