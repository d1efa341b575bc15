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

/// Content of rosbag2's metadata.yaml, and of its copy in the table `metadata`.
struct BagMetadata {
    struct File {
        std::string path;  ///< path relative to the bag
        Time first{}, last{};
        std::uint64_t messages = 0;
    };
    struct Topic {
        TopicInfo info;  ///< without the definition
        std::uint64_t messages = 0;
    };
    int version = WrittenVersion;
    std::string storage = "sqlite3";
    std::string compression;          ///< compression_format; empty: not compressed
    bool compressesMessages = false;  ///< compression_mode: each message is compressed, not whole files
    std::vector<File> files;
    std::vector<Topic> topics;
    std::map<std::string, std::string> custom;  ///< custom_data

    /// Version of ROS 2 Iron. Newer ROS versions can read it, but Iron can read no newer version.
    static constexpr int WrittenVersion = 8;
    [[nodiscard]] std::uint64_t messages() const;
    /// Returns how many messages were ever written to the file @p name: those that were counted, and those
    /// that were already missing then. 0: the file is not listed.
    [[nodiscard]] std::uint64_t writtenInto(const std::string& name) const;
};

/// Key in custom_data for the last sequence that the counts of @ref BagMetadata include. It marks a bag of
/// Leitstand.
inline constexpr std::string_view CountedKey = "leitstand_counted_to";

/// Key in custom_data, in the copy of the metadata within a file: the writer finished this file.
inline constexpr std::string_view ClosedKey = "leitstand_closed";
/// Prefix of keys in custom_data, followed by a file's name: how many of its messages were already lost when
/// it was counted.
inline constexpr std::string_view MissingKey = "leitstand_missing_in_";

/// Parses a value of custom_data. Empty unless the whole of @p text is one number.
[[nodiscard]] std::optional<std::uint64_t> numberIn(const std::string& text);

/// Returns @p metadata as YAML: the content of metadata.yaml, or if @p bare is true, that of the table
/// `metadata`.
[[nodiscard]] std::string yamlOf(const BagMetadata& metadata, bool bare);
/// Parses YAML in either form of yamlOf(). Errors contain the file name @p name.
[[nodiscard]] Result<BagMetadata> parseMetadata(const std::string& yaml, const std::string& name);

}  // namespace leitstand::detail
