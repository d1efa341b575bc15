#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/io/bag/detail/sqlite.h"
#include "core/io/bag/writing/bag_store.h"
#include "core/io/bag/writing/session_folder.h"

namespace leitstand::detail {

/// One session as a new rosbag2 file (schema version 4) in a mission's folder.
class SqliteStore final : public BagStore {
public:
    [[nodiscard]] static Result<std::unique_ptr<BagStore>> create(SessionFolder folder);
    ~SqliteStore() override = default;

    [[nodiscard]] std::optional<StoreProblem> commit(const BagBatch& batch) override;
    [[nodiscard]] std::uint64_t freeBytes() override { return m_folder.freeBytes(); }
    [[nodiscard]] std::optional<StoreProblem> close() override;
    [[nodiscard]] const std::filesystem::path& file() const override { return m_folder.file(); }
    [[nodiscard]] std::uint64_t earlierSequence() const override { return m_folder.earlierSequence(); }

private:
    /// Counts and ids while a transaction changes them. They become valid when the transaction is on the
    /// disk.
    struct Books : SessionBooks {
        std::set<std::string> definitions;  // types
    };
    explicit SqliteStore(SessionFolder folder)
        : m_folder(std::move(folder)), m_books{m_folder.newBooks(), {}} {}

    [[nodiscard]] std::optional<StoreProblem> createTables();
    [[nodiscard]] std::optional<StoreProblem> writeAll(const BagBatch& batch, Books& books);
    [[nodiscard]] std::optional<StoreProblem> insertTopic(const TopicInfo& topic, Books& books);
    [[nodiscard]] std::optional<StoreProblem> insertEvent(const RawEvent& event, std::size_t index,
                                                          Books& books);
    [[nodiscard]] std::optional<StoreProblem> storeMetadata(const Books& books);
    [[nodiscard]] std::optional<StoreProblem> checked(int code, std::size_t event = 0) const;
    void checkpointWhenLong();

    SessionFolder m_folder;
    Books m_books;
    int m_walFrames = 0;     // in the write-ahead log
    bool m_closing = false;  // the next metadata are the last ones
    Database m_database;
    Statement m_begin, m_commit, m_rollback, m_insert, m_insertTopic, m_insertDefinition, m_metadata;
};

}  // namespace leitstand::detail
