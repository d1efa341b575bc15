#include "core/io/robot/stream_reader.h"

#include <algorithm>
#include <map>

#include "core/base/words.h"
#include "core/event/stream_role.h"
#include "core/io/robot/reading_reader.h"
#include "core/io/robot/robot_keys.h"
#include "core/io/robot/robot_names.h"
#include "core/robot/streams/stream_defaults.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand::detail {
namespace {

constexpr double LongestTime = 86'400.0;  ///< [s]
constexpr int DeepestHistory = 100'000;
class StreamReader {
public:
    StreamReader(RobotDescription& robot, YamlErrors& errors) : m_robot(robot), m_errors(errors) {
        for (const auto& sensor : robot.sensors) m_sensors.push_back(sensor.first);
    }

    void read(const YamlPlace& place) {
        const YamlFields fields(place, StreamKeys, m_errors);
        if (!place.value.IsMap()) return;
        StreamRole role = StreamRole::Points;
        if (!fields.has("role")) {
            fields.fail("role", translate("leitstand::Error",
                                          "expected what the topic carries, such as points, found nothing"));
            return;
        }
        if (!fields.choice("role", role, roleWords())) return;
        std::string sensor;
        readSensor(fields, role, sensor);
        // A robot whose name was refused still gets topics.
        StreamDescription stream =
            defaultStream(role, m_robot.name.empty() ? "robot" : m_robot.name, sensor, m_robot.tfPrefix);
        readType(fields, stream);
        readTopic(fields, stream);
        if (isDepthStream(stream)) {
            stream.qos = streamFacts(StreamRole::Picture).qos;
            if (!fields.has("sensor")) failCamera(fields);
        }
        if (fields.has("qos")) readQos(fields.at("qos"), stream);
        readSpecials(fields, stream);
        fields.flag("record", stream.record);
        if (streamFacts(role).single)
            once(fields, m_roles, toString(role), "role",
                 translatable("leitstand::Error",
                              "expected one stream of this role, found {} of line {} again"));
        once(fields, m_topics, stream.topic, "topic",
             translatable("leitstand::Error", "expected a topic of its own, found {} of line {} again"));
        m_robot.streams.push_back(std::move(stream));
    }

private:
    using Lines = std::map<std::string, int>;

    /// Reports an error when @p what occurred before. @p words have places for @p what and its earlier line.
    void once(const YamlFields& fields, Lines& lines, const std::string& what, const char* key,
              const char* words) {
        const int line = fields.at(key).line;
        const auto [first, added] = lines.emplace(what, line);
        if (!added)
            fields.fail(key,
                        leitstand::fill(translate("leitstand::Error", words), shown(what), first->second));
    }

    static void failCamera(const YamlFields& fields) {
        fields.fail("sensor",
                    translate("leitstand::Error",
                              "expected the camera that it belongs to, a name under sensors, found nothing"));
    }

    void readSensor(const YamlFields& fields, StreamRole role, std::string& sensor) {
        if (!fields.text("sensor", sensor)) return;
        if (!fields.has("sensor")) {
            if (streamFacts(role).ofCamera) failCamera(fields);
        } else if (m_sensors.empty()) {
            fields.fail("sensor",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected a name under sensors, which has none, found {}"),
                                        shown(sensor)));
        } else if (!m_robot.sensors.contains(sensor)) {
            fields.fail(
                "sensor",
                leitstand::fill(translate("leitstand::Error", "expected {} (under sensors), found {}{}"),
                                anyOf(m_sensors), shown(sensor), likely(sensor, m_sensors)));
        }
    }

    static void readType(const YamlFields& fields, StreamDescription& stream) {
        const auto types = typesOf(stream.role);
        std::string type = stream.type;
        if (!fields.text("type", type)) return;
        if (streamFacts(stream.role).anyType && isTypeName(type)) {
            stream.type = type;
            return;
        }
        if (std::find(types.begin(), types.end(), type) == types.end()) {
            const std::vector<std::string> known(types.begin(), types.end());
            fields.fail("type", leitstand::fill(
                                    translate("leitstand::Error", "expected {} for {}, found {}{}"),
                                    anyOf(known), toString(stream.role), shown(type), likely(type, known)));
            return;
        }
        stream.type = type;
        // Raw pictures are not on topics called "compressed".
        const std::string ending = "/compressed";
        if (type == "sensor_msgs/msg/Image" && stream.topic.ends_with(ending))
            stream.topic.resize(stream.topic.size() - ending.size());
    }

    void readTopic(const YamlFields& fields, StreamDescription& stream) const {
        std::string topic = stream.topic;
        if (!fields.has("topic") || !fields.text("topic", topic)) return;
        if (!isRosName(topic)) {
            fields.fail("topic",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected a topic such as /kurt3d/odom (words of letters, "
                                                  "digits and _ that begin with no digit), found {}"),
                                        shown(topic)));
        } else if (topic.starts_with("/leitstand/")) {
            fields.fail(
                "topic",
                leitstand::fill(translate("leitstand::Error",
                                          "expected a topic of the robot, found one of the stations: {}"),
                                shown(topic)));
        } else {
            stream.topic = topic;
        }
    }

    void readQos(const YamlPlace& place, StreamDescription& stream) {
        const YamlFields fields(place, QosKeys, m_errors);
        fields.choice("reliability", stream.qos.reliability, reliabilityWords());
        fields.choice("durability", stream.qos.durability, durabilityWords());
        fields.count("depth", stream.qos.depth, 0, DeepestHistory);
        fields.number("lifespan", stream.qos.lifespan, 0.0, LongestTime, " s");
        fields.number("deadline", stream.qos.deadline, 0.0, LongestTime, " s");
        if (stream.role == StreamRole::StopCommand && stream.qos.lifespan > 0.0)
            fields.fail("lifespan",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected 0, since a stop never grows old, found \"{}\""),
                                        stream.qos.lifespan));
    }

    void readSpecials(const YamlFields& fields, StreamDescription& stream) {
        const auto only = [&](const char* key, bool fits, const char* words) {
            if (fields.has(key) && !fits)
                fields.fail(key, leitstand::fill(translate("leitstand::Error", words), toString(stream.role),
                                                 stream.type));
            return fields.has(key) && fits;
        };
        if (only("stamp", isCommand(stream.role) && stream.type != "geometry_msgs/msg/Twist",
                 translatable("leitstand::Error",
                              "expected it only for commands that have a stamp, found it for {} of type {}")))
            fields.choice("stamp", stream.stamp, stampWords());
        if (only("hardware_id", stream.role == StreamRole::Diagnostics,
                 translatable("leitstand::Error",
                              "expected it only for diagnostics, found it for {} of type {}")))
            fields.text("hardware_id", stream.hardwareId, true);
        if (only("maps", stream.role == StreamRole::Points || stream.role == StreamRole::Ranges,
                 translatable("leitstand::Error",
                              "expected it only for points and ranges, found it for {} of type {}"))) {
            fields.flag("maps", stream.maps);
            if (stream.maps)
                once(fields, m_maps, "true", "maps",
                     translatable("leitstand::Error",
                                  "expected one stream that makes the map, found {} of line {} again"));
        }
        readGroup(fields, stream);
        if (stream.role == StreamRole::Reading) {
            readReadings(fields, stream, m_errors);
        } else if (fields.has("readings")) {
            fields.fail("readings",
                        leitstand::fill(
                            translate("leitstand::Error", "expected it only for reading, found it for {}"),
                            toString(stream.role)));
        }
        if (!only(
                "thermal", stream.role == StreamRole::Thermal,
                translatable("leitstand::Error", "expected it only for thermal, found it for {} of type {}")))
            return;
        const YamlFields thermal(fields.at("thermal"), ThermalKeys, m_errors);
        thermal.number("scale", stream.thermal.scale, 1e-6, 100.0, " K");
        thermal.number("offset", stream.thermal.offset, -1000.0, 1000.0, " K");
        thermal.flag("measured", stream.thermal.measured);
    }

    void readGroup(const YamlFields& fields, StreamDescription& stream) {
        if (stream.role != StreamRole::JointCommand) {
            if (fields.has("group"))
                fields.fail("group", leitstand::fill(translate("leitstand::Error",
                                                               "expected it only for joint_command, found it "
                                                               "for {}"),
                                                     toString(stream.role)));
            return;
        }
        std::vector<std::string> names;
        for (const JointGroup& group : m_robot.jointGroups) names.push_back(group.name);
        const auto refuse = [&](const std::string& found) {
            fields.fail("group",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected the name of one of joint_groups, found {}{}"),
                                        found, likely(stream.group, names)));
        };
        if (!fields.has("group")) return refuse(translate("leitstand::Error", "nothing"));
        if (!fields.text("group", stream.group)) return;
        const auto found = std::find_if(m_robot.jointGroups.begin(), m_robot.jointGroups.end(),
                                        [&](const JointGroup& group) { return group.name == stream.group; });
        if (found == m_robot.jointGroups.end()) return refuse(shown(stream.group));
        once(fields, m_groups, stream.group, "group",
             translatable("leitstand::Error",
                          "expected one stream for each group, found {} of line {} again"));
        if (found->mode == JointCommandMode::Velocity && stream.type == "trajectory_msgs/msg/JointTrajectory")
            fields.fail("type", translate("leitstand::Error",
                                          "expected positions in a JointTrajectory, found a group that is "
                                          "commanded by velocity"));
    }

    RobotDescription& m_robot;
    YamlErrors& m_errors;
    std::vector<std::string> m_sensors;
    Lines m_topics, m_roles, m_maps, m_groups;
};

}  // namespace

void readStreams(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("streams")) {
        fields.fail("streams", translate("leitstand::Error", "expected a list of topics, found nothing"));
        return;
    }
    StreamReader reader(robot, errors);
    for (const YamlPlace& place : fields.list("streams")) reader.read(place);
    distinguishReadings(robot);
}

}  // namespace leitstand::detail
