#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/io/bag/topic_info.h"

namespace leitstand::detail {

/// What rosbag2's metadata.yaml and its copy in the table `metadata` say.
struct BagMetadata {
    struct File {
        std::string path;  ///< relative to the bag
        Time first{}, last{};
        std::uint64_t messages = 0;
    };
    struct Topic {
        TopicInfo info;  ///< without definition
        std::uint64_t messages = 0;
    };
    int version = WrittenVersion;
    std::string storage = "sqlite3";
    std::string compression;  ///< compression_format; empty: none
    std::vector<File> files;
    std::vector<Topic> topics;
    std::map<std::string, std::string> custom;  ///< custom_data

    /// ROS 2 Iron's: newer ROS reads it too, but Iron reads no later one.
    static constexpr int WrittenVersion = 8;
    [[nodiscard]] std::uint64_t messages() const;
    /// Messages that file @p name held once: those counted in it, and those that were missing already when
    /// they were counted. 0: it is not listed.
    [[nodiscard]] std::uint64_t writtenInto(const std::string& name) const;
};

/// custom_data that marks a bag of ours: the last sequence that the counts of @ref BagMetadata know of.
inline constexpr std::string_view CountedKey = "leitstand_counted_to";

/// custom_data of a file's own copy: its writer finished it.
inline constexpr std::string_view ClosedKey = "leitstand_closed";
/// custom_data with a file's name behind it: how many of its messages were lost before the counts were made.
inline constexpr std::string_view MissingKey = "leitstand_missing_in_";

/// The number that all of a value of custom_data is.
[[nodiscard]] std::optional<std::uint64_t> numberIn(const std::string& text);

/// @p metadata as YAML: the content of metadata.yaml, or bare as the table has it.
[[nodiscard]] std::string yamlOf(const BagMetadata& metadata, bool bare);
/// Reads either form; @p name stands in errors.
[[nodiscard]] Result<BagMetadata> parseMetadata(const std::string& yaml, const std::string& name);

}  // namespace leitstand::detail
