#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/detail/sqlite.h"
#include "core/io/bag/reading/bag_file.h"
#include "core/io/bag/salvage/overlay_vfs.h"

namespace leitstand::detail {

/// A file of a bag that SQLite can read: rosbag2's schema, versions 1 to 4.
class SqliteFile final : public BagFile {
public:
    /// Opens @p file. @p live: a writer has it open, so SQLite's own locks are used. Otherwise the file is
    /// neither changed nor locked. Error when SQLite cannot read it; the text begins with the file's name.
    [[nodiscard]] static Result<std::unique_ptr<BagFile>> open(const std::filesystem::path& file, bool live);

    [[nodiscard]] Outcome fetch(const RowQuery& query, std::vector<BagRow>& rows) override;
    [[nodiscard]] std::optional<BagRow> row(std::uint64_t id, bool& broken) override;
    [[nodiscard]] std::optional<BagRow> lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                                 bool& broken) override;
    [[nodiscard]] std::uint64_t idAt(Time time, bool& broken) override;
    void count() override;

private:
    explicit SqliteFile(std::filesystem::path file) : m_file(std::move(file)) {}
    [[nodiscard]] Result<void> connect(bool live);
    [[nodiscard]] Result<void> checkTables();
    [[nodiscard]] Result<void> readTopics();
    void readDefinitions();
    [[nodiscard]] Result<void> readSpan();
    void readCounts();
    void publishLog();
    [[nodiscard]] bool addTail(std::uint64_t countedTo);
    [[nodiscard]] bool hasColumn(const char* table, std::string_view column) const;
    [[nodiscard]] Error problem(std::string_view place) const;

    [[nodiscard]] Outcome fetchOrdered(const RowQuery& query, std::vector<BagRow>& rows);
    [[nodiscard]] Outcome fetchTopics(const RowQuery& query, std::vector<BagRow>& rows);

    std::filesystem::path m_file;
    std::unique_ptr<OverlayVfs> m_vfs;  // declared before the connection, which is destroyed first
    Database m_database;
    bool m_byTopic = false;  // the file has our index of topics
    bool m_byTime = false;   // the file has rosbag2's index of times
    bool m_logGone = false;  // the write-ahead log of the file is missing
};

/// Returns the current row of @p statement: id, topic_id, timestamp, data.
[[nodiscard]] BagRow rowOf(const Statement& statement);

}  // namespace leitstand::detail
