#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/bag/salvage/page_file.h"

namespace leitstand::detail {

/// A row of a table as its leaf page has it.
struct PageCell {
    std::uint64_t row = 0;             ///< its id
    std::uint64_t size = 0;            ///< of the record [B]
    std::uint32_t page = 0;            ///< where the cell is
    std::size_t offset = 0;            ///< of the record's local part, in the page
    std::size_t local = 0;             ///< bytes of the record in the page
    std::uint32_t overflow = 0;        ///< page of the rest; 0: there is none
    std::span<const std::byte> begin;  ///< the local part; valid during the call
};

/// Calls @p take with every cell that a page of @p file holds as a leaf of some table, if it makes sense:
/// bounds within page and file.
void eachCell(const PageFile& file, const std::function<void(const PageCell&)>& take);

/// A column of a record: SQLite's serial type, and where its content stands.
struct PageColumn {
    std::uint64_t type = 0;
    std::uint64_t offset = 0, size = 0;  ///< in the record [B]
    [[nodiscard]] bool isNull() const { return type == 0; }
    [[nodiscard]] bool isInteger() const { return (type >= 1 && type <= 6) || type == 8 || type == 9; }
    [[nodiscard]] bool isBlob() const { return type >= 12 && type % 2 == 0; }
    [[nodiscard]] bool isText() const { return type >= 13 && type % 2 == 1; }
};

/// The columns that the header at the beginning of a record tells, when header and columns are just as long
/// as the record; empty otherwise, or when there are more than @p most.
[[nodiscard]] std::vector<PageColumn> columnsOf(const PageCell& cell, std::size_t most = 8);
/// The number in an integer column, whose content must stand in @p record.
[[nodiscard]] std::optional<std::int64_t> integerIn(std::span<const std::byte> record,
                                                    const PageColumn& column);
[[nodiscard]] std::optional<std::string> textIn(std::span<const std::byte> record, const PageColumn& column);

/// The whole record of @p cell with what its overflow pages hold; empty when they do not hold it.
[[nodiscard]] std::optional<std::vector<std::byte>> wholeRecord(const PageFile& file, const PageCell& cell);

}  // namespace leitstand::detail
