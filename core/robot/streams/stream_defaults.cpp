#include "core/robot/streams/stream_defaults.h"

#include <string_view>

#include <fmt/format.h>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

/// Whether the topic is /tf, for robots without one of their own.
bool isOnSharedTree(const StreamFacts& row, TfPrefix prefix) {
    return row.shared && prefix != TfPrefix::Topic;
}

}  // namespace

StreamDescription defaultStream(StreamRole role, const std::string& robot, const std::string& sensor,
                                TfPrefix prefix) {
    const StreamFacts& row = streamFacts(role);
    StreamDescription stream;
    stream.role = role;
    stream.sensor = sensor;
    if (row.topic.starts_with('/')) {
        stream.topic = row.topic;
    } else {
        const std::string space = isOnSharedTree(row, prefix) ? std::string() : robot + "/";
        const std::string camera = sensor.empty() ? std::string("camera") : sensor;
        stream.topic = fmt::format("/{}{}{}", space, row.ofCamera ? camera + "/" : std::string(), row.topic);
    }
    stream.type = row.types.front();
    stream.qos = row.qos;
    if (role == StreamRole::Diagnostics) stream.hardwareId = robot;
    return stream;
}

}  // namespace leitstand
