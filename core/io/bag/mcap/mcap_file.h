#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/mcap/mcap_bytes.h"
#include "core/io/bag/mcap/mcap_index.h"
#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {

/// An MCAP file of rosbag2 or another recorder: with an index or without, compressed or not, and cut off
/// where its writer was killed. Messages have ids from 1 in the order of their log times.
class McapFile final : public BagFile {
public:
    /// Opens @p file. Error when it cannot be read or is no MCAP file; what of it is damaged is in the facts'
    /// problems.
    [[nodiscard]] static Result<std::unique_ptr<BagFile>> open(const std::filesystem::path& file);

    [[nodiscard]] Outcome fetch(const RowQuery& query, std::vector<BagRow>& rows) override;
    [[nodiscard]] std::optional<BagRow> row(std::uint64_t id, bool& broken) override;
    [[nodiscard]] std::optional<BagRow> lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                                 bool& broken) override;
    [[nodiscard]] std::uint64_t idAt(Time time, bool& broken) override;
    void count() override {}  // counted when opened
    [[nodiscard]] std::vector<std::string> newProblems() override;

private:
    using Records = std::shared_ptr<const std::vector<std::byte>>;

    McapFile(std::filesystem::path file, McapBytes bytes);
    void setFacts();
    /// Returns the message with id @p number + 1; empty, after a problem, when it cannot be read.
    [[nodiscard]] std::optional<BagRow> rowAt(std::size_t number);
    [[nodiscard]] Records recordsOf(std::uint32_t chunk);
    void report(const std::string& what);

    std::filesystem::path m_file;
    McapBytes m_bytes;
    McapIndex m_index;
    std::map<std::int64_t, std::vector<std::uint32_t>> m_ofTopic;  ///< numbers of entries by channel, rising
    std::list<std::pair<std::uint32_t, Records>> m_chunks;         ///< that were read last, newest first
    std::set<std::string> m_reported;
    std::vector<std::string> m_new;
};

}  // namespace leitstand::detail
