#include "app/services/domain/topic_role.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/message_catalog.h"

namespace leitstand {
namespace {

/// Whether markers on @p topic are drawn unasked: not those that people set in RViz, outlines that the
/// robot's own mark shows, or whole maps.
bool isWorthDrawing(const SeenTopic& topic) {
    const std::string_view leaf = std::string_view(topic.name).substr(topic.name.rfind('/') + 1);
    constexpr std::array<std::string_view, 4> Of = {"amcl_pose", "pose", "localization_pose", "pcl_pose"};
    if (topic.type == "geometry_msgs/msg/PoseWithCovarianceStamped")
        return std::find(Of.begin(), Of.end(), leaf) != Of.end();
    constexpr std::array<std::string_view, 5> Not = {"published_footprint", "cells_vis", "voxel", "octomap",
                                                     "tsdf"};
    return std::none_of(Not.begin(), Not.end(),
                        [&](std::string_view part) { return leaf.find(part) != std::string_view::npos; });
}

/// Whether a part of @p name is one of @p words.
bool hasPart(std::string_view name, std::span<const std::string_view> words) {
    for (std::size_t begin = 0; begin <= name.size();) {
        const auto end = std::min(name.find_first_of("/_", begin), name.size());
        const std::string_view part = name.substr(begin, end - begin);
        if (std::find(words.begin(), words.end(), part) != words.end()) return true;
        begin = end + 1;
    }
    return false;
}

/// Whether @p topic, whose type @p row has, matches the row by name, words or type.
bool isGuessedBy(const StreamFacts& row, const SeenTopic& topic) {
    const std::string_view leaf = leafOf(topic.name);
    switch (row.guessedBy) {
        case GuessedBy::Name:
            return leaf == row.topic;
        case GuessedBy::Words:
            return hasPart(isCommand(row.role) ? leaf : std::string_view(topic.name), row.words);
        case GuessedBy::Type:
            break;
    }
    return row.words.empty() || topic.type == row.types.front() || hasPart(topic.name, row.words);
}

/// Returns the role of @p topic in the table of streams, among commands or among what robots publish. A match
/// by name goes before a match by type.
std::optional<StreamRole> roleInTable(const SeenTopic& topic, bool commands) {
    const StreamFacts* found = nullptr;
    for (const StreamFacts& row : streamTable()) {
        const bool known = std::find(row.types.begin(), row.types.end(), topic.type) != row.types.end();
        if (isCommand(row.role) != commands || !known || !isGuessedBy(row, topic)) continue;
        if (isPictureType(topic.type) && !row.picture) continue;  // depths: addDepths()
        if (found == nullptr || (found->guessedBy == GuessedBy::Type && row.guessedBy != GuessedBy::Type))
            found = &row;
    }
    return found == nullptr ? std::nullopt : std::optional(found->role);
}

/// Whether a controller of joints listens to @p topic. Only a robot's file tells which joints these are.
bool movesJoints(const SeenTopic& topic) {
    const auto types = typesOf(StreamRole::JointCommand);
    const bool known = std::find(types.begin(), types.end(), topic.type) != types.end();
    return topic.read && known && topic.type != "sensor_msgs/msg/JointState";
}

/// Parts of the names of pictures that hold distances.
constexpr std::array<std::string_view, 1> OfDepth = {"depth"}, OfStereo = {"stereo"};
constexpr std::array<std::string_view, 2> OfEyes = {"left", "right"};
/// Pictures that ouster_ros makes of its scans.
constexpr std::array<std::string_view, 4> OfScanners = {"range_image", "signal_image", "reflec_image",
                                                        "nearir_image"};
/// Whether a topic's name tells of depths. A stereo camera that names no eye publishes what it computes from
/// both.
bool namesDepths(std::string_view name) {
    return hasPart(name, OfDepth) || (hasPart(name, OfStereo) && !hasPart(name, OfEyes));
}

}  // namespace

std::string_view leafOf(std::string_view name) {
    return name.substr(name.rfind('/') + 1);
}

bool isOfDepths(const SeenTopic& topic) {
    const bool compressed = topic.type == "sensor_msgs/msg/CompressedImage";
    return compressed ? leafOf(topic.name) == "compressedDepth"
                      : topic.type == "sensor_msgs/msg/Image" && namesDepths(topic.name);
}

std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark) {
    if (!topic.obstacle.empty()) {
        remark = topic.obstacle;
        return std::nullopt;
    }
    const std::string_view name = topic.name, leaf = leafOf(name);
    if (name.starts_with("rq/") || name.starts_with("rr/") ||
        name.find("/_action/") != std::string_view::npos) {
        remark = "of a service or an action that the station does not call";
        return std::nullopt;
    }
    if (!name.starts_with('/')) {
        remark = "not a topic of ROS 2";
        return std::nullopt;
    }
    const bool ours = topic.type.starts_with("leitstand_msgs/");
    if (movesJoints(topic)) {
        remark = "moves joints: the station uses it once the robot's file describes them (joint_groups)";
        return std::nullopt;
    }
    if (const auto command = roleInTable(topic, true)) {
        if (!topic.read && !ours) remark = "nobody listens to it";
        return command;
    }
    const auto role = roleInTable(topic, false);
    if (ours && role && streamFacts(*role).guessedBy == GuessedBy::Name) return role;
    if (!topic.written) {
        remark = "nobody publishes it, and the station has nothing to say there";
        return std::nullopt;
    }
    if (isOfDepths(topic)) {
        remark =
            "pictures of depths: without another scanner the station takes them, else where the robot's "
            "file names them (role points)";
        return std::nullopt;
    }
    if (leaf == "theora" || leaf == "zstd") {
        remark = fmt::format(
            "pictures of the transport \"{}\" are not understood, expected raw or compressed", leaf);
        return std::nullopt;
    }
    if (role == StreamRole::Picture &&
        std::find(OfScanners.begin(), OfScanners.end(), leaf) != OfScanners.end()) {
        remark = "what a 3D scanner sees as a picture: the station does not use it";
        return std::nullopt;
    }
    const bool depth = namesDepths(name);
    if (role == StreamRole::Picture && depth) {
        remark = "colours of depths: the station does not use them";
        return std::nullopt;
    }
    if (!role) {
        const auto rows = streamTable();
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const StreamFacts& one) {
            return !isCommand(one.role) &&
                   std::find(one.types.begin(), one.types.end(), topic.type) != one.types.end();
        });
        const bool text = topic.type == "std_msgs/msg/String" || topic.type == "std_msgs/msg/Empty";
        if (row != rows.end() && !text) {
            remark = fmt::format("role {} takes it, if the robot's file names it", nameOf(row->role));
        } else {
            remark = text ? "nothing in the station shows it"
                     : findMessageType(topic.type) != nullptr
                         ? "its numbers are shown, if the robot's file names them (role reading)"
                         : fmt::format("type {} is not known: it can be recorded, not shown", topic.type);
        }
        return std::nullopt;
    }
    if (*role == StreamRole::Markers && !isWorthDrawing(topic)) {
        remark =
            "what is drawn there is of little use here: the station draws it where the robot's file names it "
            "(role markers)";
        return std::nullopt;
    }
    if (*role == StreamRole::Thermal)
        remark = "taken as infrared: check scale and offset in the robot's file";
    return role;
}

}  // namespace leitstand
