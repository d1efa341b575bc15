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

/// A row of an SQLite table, as it is stored in a leaf page.
struct PageCell {
    std::uint64_t row = 0;             ///< id of the row
    std::uint64_t size = 0;            ///< size of the record [B]
    std::uint32_t page = 0;            ///< page that holds the cell
    std::size_t offset = 0;            ///< where the local part of the record begins in the page [B]
    std::size_t local = 0;             ///< size of the local part [B]
    std::uint32_t overflow = 0;        ///< page with the rest of the record; 0: there is none
    std::span<const std::byte> begin;  ///< local part of the record; valid during the call
};

/// Calls @p take with every cell of the leaf pages of @p file. Cells that reach beyond their page or the file
/// are skipped.
void eachCell(const PageFile& file, const std::function<void(const PageCell&)>& take);

/// A column of a record: SQLite's serial type and the place of its content.
struct PageColumn {
    std::uint64_t type = 0;
    std::uint64_t offset = 0, size = 0;  ///< place of the content in the record [B]
    [[nodiscard]] bool isNull() const { return type == 0; }
    [[nodiscard]] bool isInteger() const { return (type >= 1 && type <= 6) || type == 8 || type == 9; }
    [[nodiscard]] bool isBlob() const { return type >= 12 && type % 2 == 0; }
    [[nodiscard]] bool isText() const { return type >= 13 && type % 2 == 1; }
};

/// Returns the columns that the header of a record lists. Empty when header and columns together are not
/// exactly as long as the record, or when there are more than @p most columns.
[[nodiscard]] std::vector<PageColumn> columnsOf(const PageCell& cell, std::size_t most = 8);
/// Returns the number in an integer column; empty when its content is not within @p record.
[[nodiscard]] std::optional<std::int64_t> integerIn(std::span<const std::byte> record,
                                                    const PageColumn& column);
[[nodiscard]] std::optional<std::string> textIn(std::span<const std::byte> record, const PageColumn& column);

/// Returns the whole record of @p cell, with the part in overflow pages; empty when these pages do not hold
/// all of it.
[[nodiscard]] std::optional<std::vector<std::byte>> wholeRecord(const PageFile& file, const PageCell& cell);

}  // namespace leitstand::detail
