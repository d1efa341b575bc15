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
    /// Opens @p file. With @p live, a writer has it, with whom SQLite's own locks keep us apart; else nothing
    /// of it is changed or locked. An error when SQLite cannot read it, which begins with its name.
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
    void tellLog();
    [[nodiscard]] bool addTail(std::uint64_t countedTo);
    [[nodiscard]] bool hasColumn(const char* table, std::string_view column) const;
    [[nodiscard]] Error problem(std::string_view place) const;

    [[nodiscard]] Outcome fetchOrdered(const RowQuery& query, std::vector<BagRow>& rows);
    [[nodiscard]] Outcome fetchTopics(const RowQuery& query, std::vector<BagRow>& rows);

    std::filesystem::path m_file;
    std::unique_ptr<OverlayVfs> m_vfs;  // before the connection, which goes first
    Database m_database;
    bool m_byTopic = false;  // our index of topics is there
    bool m_byTime = false;   // rosbag2's index of times is there
    bool m_logGone = false;  // the write-ahead log that belongs to the file is not there
};

/// The row that @p statement stands on: id, topic_id, timestamp, data.
[[nodiscard]] BagRow rowOf(const Statement& statement);

}  // namespace leitstand::detail
