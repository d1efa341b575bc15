#include "core/io/bag/detail/bag_metadata.h"

#include <algorithm>
#include <charconv>
#include <exception>
#include <filesystem>
#include <limits>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"

namespace leitstand::detail {

namespace {

constexpr const char* Root = "rosbag2_bagfile_information";

std::int64_t nanoseconds(Time time) {
    return time.time_since_epoch().count();
}

YAML::Node span(Time first, Time last, YAML::Node into) {
    first = std::max(first, Time{});
    into["starting_time"]["nanoseconds_since_epoch"] = nanoseconds(first);
    into["duration"]["nanoseconds"] = (std::max(last, first) - first).count();  // rosbag2 reads it unsigned
    return into;
}

/// Returns the first and last time over all @p files with messages; epoch when there are none.
std::pair<Time, Time> wholeSpan(const std::vector<BagMetadata::File>& files) {
    Time first = Time::max(), last{};
    for (const auto& file : files) {
        if (file.messages == 0) continue;
        first = std::min(first, file.first);
        last = std::max(last, file.last);
    }
    return first == Time::max() ? std::pair{Time{}, Time{}} : std::pair{first, last};
}

YAML::Node node(const BagMetadata& metadata) {
    YAML::Node root;
    root["version"] = metadata.version;
    root["storage_identifier"] = metadata.storage;
    const auto [first, last] = wholeSpan(metadata.files);
    span(first, last, root);
    root["message_count"] = metadata.messages();
    YAML::Node topics(YAML::NodeType::Sequence);
    for (const auto& topic : metadata.topics) {
        YAML::Node entry;
        entry["topic_metadata"]["name"] = topic.info.name;
        entry["topic_metadata"]["type"] = topic.info.type;
        entry["topic_metadata"]["serialization_format"] = topic.info.serialization;
        entry["topic_metadata"]["offered_qos_profiles"] = topic.info.qosProfiles;
        entry["topic_metadata"]["type_description_hash"] = topic.info.typeHash;
        entry["message_count"] = topic.messages;
        topics.push_back(entry);
    }
    root["topics_with_message_count"] = topics;
    root["compression_format"] = metadata.compression;
    root["compression_mode"] = "";
    YAML::Node paths(YAML::NodeType::Sequence), files(YAML::NodeType::Sequence);
    for (const auto& file : metadata.files) {
        paths.push_back(file.path);
        YAML::Node entry;
        entry["path"] = file.path;
        span(file.first, file.last, entry);
        entry["message_count"] = file.messages;
        files.push_back(entry);
    }
    root["relative_file_paths"] = paths;
    root["files"] = files;
    YAML::Node custom(YAML::NodeType::Map);
    for (const auto& [key, value] : metadata.custom) custom[key] = value;
    root["custom_data"] = custom;
    root["ros_distro"] = "";
    return root;
}

template <class T>
T valueOr(const YAML::Node& node, T otherwise) {
    return node && node.IsScalar() ? node.as<T>(otherwise) : otherwise;
}

Time timeOf(const YAML::Node& node) {
    const auto value = valueOr<std::int64_t>(node["nanoseconds_since_epoch"], 0);
    return Time(std::chrono::nanoseconds(std::max<std::int64_t>(value, 0)));
}

BagMetadata::File fileOf(const YAML::Node& node) {
    BagMetadata::File file;
    file.path = valueOr<std::string>(node["path"], "");
    file.first = timeOf(node["starting_time"]);
    const auto length = valueOr<std::int64_t>(node["duration"]["nanoseconds"], 0);
    const std::int64_t room = std::numeric_limits<std::int64_t>::max() - nanoseconds(file.first);
    file.last = file.first + std::chrono::nanoseconds(std::clamp<std::int64_t>(length, 0, room));
    file.messages = valueOr<std::uint64_t>(node["message_count"], 0);
    return file;
}

BagMetadata::Topic topicOf(const YAML::Node& node) {
    const YAML::Node of = node["topic_metadata"];
    BagMetadata::Topic topic;
    topic.info.name = valueOr<std::string>(of["name"], "");
    topic.info.type = valueOr<std::string>(of["type"], "");
    topic.info.serialization = valueOr<std::string>(of["serialization_format"], "cdr");
    const YAML::Node qos = of["offered_qos_profiles"];
    if (qos && qos.IsSequence()) {
        topic.info.qosProfiles = YAML::Dump(qos);  // version 9 has a list in place of a text
    } else {
        topic.info.qosProfiles = valueOr<std::string>(qos, "");
    }
    topic.info.typeHash = valueOr<std::string>(of["type_description_hash"], "");
    topic.messages = valueOr<std::uint64_t>(node["message_count"], 0);
    return topic;
}

BagMetadata metadataOf(const YAML::Node& root) {
    BagMetadata metadata;
    metadata.version = valueOr(root["version"], 0);
    metadata.storage = valueOr<std::string>(root["storage_identifier"], "");
    const auto mode = valueOr<std::string>(root["compression_mode"], "");
    if (mode != "NONE" && mode != "none") {
        metadata.compression = valueOr<std::string>(root["compression_format"], "");
        metadata.compressesMessages = mode == "MESSAGE" || mode == "message";
    }
    if (root["files"] && root["files"].IsSequence()) {
        for (const auto& file : root["files"]) metadata.files.push_back(fileOf(file));
    }
    if (metadata.files.empty() && root["relative_file_paths"] && root["relative_file_paths"].IsSequence()) {
        for (const auto& path : root["relative_file_paths"]) {
            metadata.files.emplace_back().path = valueOr<std::string>(path, "");
        }
    }
    if (root["topics_with_message_count"] && root["topics_with_message_count"].IsSequence()) {
        for (const auto& topic : root["topics_with_message_count"]) metadata.topics.push_back(topicOf(topic));
    }
    if (root["custom_data"] && root["custom_data"].IsMap()) {
        for (const auto& entry : root["custom_data"]) {
            metadata.custom[valueOr<std::string>(entry.first, "")] = valueOr<std::string>(entry.second, "");
        }
    }
    return metadata;
}

}  // namespace

std::uint64_t BagMetadata::messages() const {
    std::uint64_t sum = 0;
    for (const auto& topic : topics) sum += topic.messages;
    return sum;
}

std::uint64_t BagMetadata::writtenInto(const std::string& name) const {
    for (const File& file : files) {
        if (std::filesystem::path(file.path).filename() != name) continue;
        const auto lost = custom.find(std::string(MissingKey) + name);
        return file.messages + (lost == custom.end() ? 0 : numberIn(lost->second).value_or(0));
    }
    return 0;
}

std::optional<std::uint64_t> numberIn(const std::string& text) {
    std::uint64_t number = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
    return number;
}

std::string yamlOf(const BagMetadata& metadata, bool bare) {
    YAML::Emitter out;
    if (bare) {
        out << node(metadata);
    } else {
        YAML::Node root;
        root[Root] = node(metadata);
        out << root;
    }
    return std::string(out.c_str()) + "\n";
}

Result<BagMetadata> parseMetadata(const std::string& yaml, const std::string& name) {
    try {
        YAML::Node root = YAML::Load(yaml);
        if (!root.IsMap())
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: expected a map of rosbag2's metadata"), name)};
        if (root[Root]) root.reset(root[Root]);
        if (!root.IsMap() || !root["storage_identifier"]) {
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: expected {} with a storage_identifier"), name, Root)};
        }
        return metadataOf(root);
    } catch (const std::exception& problem) {  // YAML's exceptions name line and column
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected rosbag2's metadata: {}"),
                                     name, problem.what())};
    }
}

}  // namespace leitstand::detail
