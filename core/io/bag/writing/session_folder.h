#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/detail/mission_folder.h"
#include "core/io/bag/writing/bag_store.h"

namespace leitstand::detail {

/// Topics and counts of the session that is being written.
struct SessionBooks {
    using TopicKey = std::pair<std::string, std::string>;  ///< name, type
    std::map<TopicKey, std::int64_t> ids;                  ///< from 1
    BagMetadata metadata;  ///< of this file alone; topics in the order of their ids
    std::uint64_t lastSequence = 0;

    /// Adds @p topic; false: it is there.
    [[nodiscard]] bool add(const TopicInfo& topic);
    /// Returns the id of the topic of @p event. Empty when @p event cannot be the next one: it has no bytes,
    /// its topic is not known, or its sequence is not higher than all earlier ones.
    [[nodiscard]] std::optional<std::int64_t> topicOfNext(const RawEvent& event) const;
    /// Counts @p event of the topic @p id.
    void count(const RawEvent& event, std::int64_t id);
};

/// The folder of a mission while a session is written into it: locked, with what is there from before.
class SessionFolder {
public:
    /// Makes @p folder if it is missing, and locks it. @p storage: see BagWriterSettings::storage.
    [[nodiscard]] static Result<SessionFolder> open(const std::filesystem::path& folder,
                                                    std::optional<BagStorage> storage);

    /// The file of this session, which does not exist yet after open().
    [[nodiscard]] const std::filesystem::path& file() const { return m_file; }
    [[nodiscard]] BagStorage storage() const { return m_storage; }
    [[nodiscard]] std::uint64_t earlierSequence() const { return m_earlierSequence; }
    /// Returns the books of a session that begins.
    [[nodiscard]] SessionBooks newBooks() const;
    /// Free space that an ordinary user may fill [B].
    [[nodiscard]] std::uint64_t freeBytes() const;
    /// Writes metadata.yaml with the earlier sessions and @p books. It is for others, since the files
    /// hold the same: failures are not reported, and the next attempt may succeed.
    void writeMetadata(const SessionBooks& books) const;
    /// Flushes the entries of the folder, and its own, to the disk.
    void sync() const;
    /// Why @p event, number @p index of its batch, cannot be written.
    [[nodiscard]] StoreProblem refusal(const RawEvent& event, std::size_t index,
                                       const SessionBooks& books) const;

private:
    SessionFolder(std::filesystem::path folder, FolderLock lock)
        : m_folder(std::move(folder)), m_lock(std::move(lock)) {}

    std::filesystem::path m_folder, m_file;
    FolderLock m_lock;
    BagStorage m_storage = BagStorage::Sqlite;
    BagMetadata m_earlier;  ///< of the sessions before this one
    std::uint64_t m_earlierSequence = 0;
};

}  // namespace leitstand::detail
