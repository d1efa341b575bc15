#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/detail/mission_folder.h"
#include "core/io/bag/detail/sqlite.h"
#include "core/io/bag/writing/bag_store.h"

namespace leitstand::detail {

/// One session as a new rosbag2 file (schema version 4) in a mission's folder.
class SqliteStore final : public BagStore {
public:
    /// Makes @p folder if it is missing, and the next numbered file in it.
    [[nodiscard]] static Result<std::unique_ptr<BagStore>> create(const std::filesystem::path& folder);
    ~SqliteStore() override = default;

    [[nodiscard]] std::optional<StoreProblem> commit(const BagBatch& batch) override;
    [[nodiscard]] std::uint64_t freeBytes() override;
    [[nodiscard]] std::optional<StoreProblem> close() override;
    [[nodiscard]] const std::filesystem::path& file() const override { return m_file; }
    [[nodiscard]] std::uint64_t earlierSequence() const override { return m_earlierSequence; }

private:
    using TopicKey = std::pair<std::string, std::string>;  // name, type
    /// Counts and ids while a transaction changes them. They become valid when the transaction is on the
    /// disk.
    struct Books {
        std::map<TopicKey, std::int64_t> ids;
        std::set<std::string> definitions;  // types
        BagMetadata metadata;               // of this file alone; topics in the order of their ids
        std::uint64_t lastSequence = 0;
    };
    SqliteStore(std::filesystem::path folder, std::filesystem::path file, FolderLock lock)
        : m_folder(std::move(folder)), m_file(std::move(file)), m_lock(std::move(lock)) {}

    [[nodiscard]] std::optional<StoreProblem> createTables();
    [[nodiscard]] std::optional<StoreProblem> writeAll(const BagBatch& batch, Books& books);
    [[nodiscard]] std::optional<StoreProblem> insertTopic(const TopicInfo& topic, Books& books);
    [[nodiscard]] std::optional<StoreProblem> insertEvent(const RawEvent& event, std::size_t index,
                                                          Books& books);
    [[nodiscard]] std::optional<StoreProblem> storeMetadata(const Books& books);
    [[nodiscard]] std::optional<StoreProblem> checked(int code, std::size_t event = 0) const;
    void checkpointWhenLong();
    void writeMetadataFile();
    [[nodiscard]] BagMetadata wholeMetadata() const;

    std::filesystem::path m_folder, m_file;
    FolderLock m_lock;
    BagMetadata m_earlier;  // of the sessions before this one
    std::uint64_t m_earlierSequence = 0;
    Books m_books;
    int m_walFrames = 0;     // in the write-ahead log
    bool m_closing = false;  // the next metadata are the last ones
    Database m_database;
    Statement m_begin, m_commit, m_rollback, m_insert, m_insertTopic, m_insertDefinition, m_metadata;
};

}  // namespace leitstand::detail
