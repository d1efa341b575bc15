#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/reading/bag_file.h"
#include "core/io/bag/salvage/page_file.h"
#include "core/io/bag/salvage/page_records.h"

namespace leitstand::detail {

/// A file of a bag that SQLite cannot read (any more). Looks at every page once and takes all that looks like
/// a row of messages. Opening reads the whole file.
class SalvagedFile final : public BagFile {
public:
    /// Searches @p file for messages. @p why: why SQLite cannot read the file; it is reported with the
    /// problems. Error when nothing is found.
    [[nodiscard]] static Result<std::unique_ptr<BagFile>> open(const std::filesystem::path& file,
                                                               const std::string& why);

    [[nodiscard]] Outcome fetch(const RowQuery& query, std::vector<BagRow>& rows) override;
    [[nodiscard]] std::optional<BagRow> row(std::uint64_t id, bool& broken) override;
    [[nodiscard]] std::optional<BagRow> lastUpTo(const std::set<std::int64_t>& topics, std::uint64_t id,
                                                 bool& broken) override;
    [[nodiscard]] std::uint64_t idAt(Time time, bool& broken) override;
    void count() override;
    [[nodiscard]] std::vector<std::string> newProblems() override;

private:
    /// Where in the file a message was found.
    struct Found {
        std::uint64_t id = 0;
        std::int64_t topic = 0;
        Time received{};
        PageCell cell;  // its span is no longer valid
        std::uint64_t dataOffset = 0;
    };
    SalvagedFile(const std::filesystem::path& file, std::size_t pageSize)
        : m_file(file), m_pages(file, pageSize) {}

    void search();
    void takeCell(const PageCell& cell);
    [[nodiscard]] bool takeMessage(const PageCell& cell, const std::vector<PageColumn>& columns);
    void takeTexts(const PageCell& cell, const std::vector<PageColumn>& columns);
    void finish(const std::string& why);
    void reportGaps();
    [[nodiscard]] std::string fewerBytes(const Found& found) const;
    [[nodiscard]] std::optional<BagRow> rowOf(const Found& found);

    std::filesystem::path m_file;
    PageFile m_pages;
    std::vector<Found> m_found;                        // by id
    std::map<std::string, std::string> m_definitions;  // by type
    std::optional<BagMetadata> m_metadata;
    std::uint64_t m_unread = 0;  // rows whose bytes could not be read after all
    std::vector<std::string> m_news;
};

}  // namespace leitstand::detail
