#include "core/io/handin/search_list.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"
#include "core/io/handin/csv_fields.h"

namespace leitstand {
namespace {

constexpr std::array<std::string_view, 7> Columns = {"sensor", "what", "m2", "percent", "x", "y", "storey"};
constexpr std::size_t WithoutStorey = Columns.size() - 1;
constexpr double MostStoreys = 1000.0;  ///< larger numbers are no storeys

}  // namespace

Result<void> writeSearchList(const std::filesystem::path& file, const std::vector<ListedSearch>& rows) {
    const bool storeys =
        std::any_of(rows.begin(), rows.end(), [](const ListedSearch& row) { return row.storey.has_value(); });
    const auto columns = std::span(Columns).first(storeys ? Columns.size() : WithoutStorey);
    std::string text = fmt::format("{}\n", fmt::join(columns, ","));
    for (const ListedSearch& row : rows) {
        const bool placed = row.what == "missed";
        if (!std::isfinite(row.area) || !std::isfinite(row.share) || !std::isfinite(row.x + row.y))
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: is not written: a figure of {} is no number"),
                file.string(), row.sensor)};
        text += fmt::format("{},{},{:.2f},{:.1f},{},{}", csvField(row.sensor), csvField(row.what), row.area,
                            100.0 * row.share, placed ? fmt::format("{:.2f}", row.x) : "",
                            placed ? fmt::format("{:.2f}", row.y) : "");
        if (storeys) text += row.storey ? fmt::format(",{}", *row.storey) : ",";
        text += '\n';
    }
    return detail::writeWhole(file, text);
}

Result<std::vector<ListedSearch>> readSearchList(const std::filesystem::path& file) {
    auto opened = CsvReader::open(file);
    if (!opened) return opened.error();
    CsvReader reader = std::move(opened).value();
    std::vector<std::string> fields;
    const bool known = reader.next(fields) && fields.size() >= WithoutStorey &&
                       fields.size() <= Columns.size() &&
                       std::equal(fields.begin(), fields.end(), Columns.begin());
    if (!known) {
        if (const auto failure = reader.failure()) return *failure;
        return reader.mismatch(fmt::format("the columns {}", fmt::join(Columns, ",")));
    }
    const std::size_t columns = fields.size();
    std::vector<ListedSearch> rows;
    while (reader.next(fields)) {
        if (fields.size() == 1 && fields.front().empty()) continue;
        if (fields.size() != columns) return reader.mismatch(fmt::format("{} fields", columns));
        ListedSearch row;
        row.sensor = fields[0];
        row.what = fields[1];
        const auto area = detail::toNumber(fields[2]), percent = detail::toNumber(fields[3]);
        if (!area || !std::isfinite(*area) || *area < 0.0) return reader.mismatch("an area as m2");
        if (!percent || !std::isfinite(*percent)) return reader.mismatch("a number as percent");
        row.area = *area;
        row.share = *percent / 100.0;
        for (std::size_t i = 4; i < columns; ++i) {
            if (fields[i].empty()) continue;
            const auto number = detail::toNumber(fields[i]);
            const bool storey = i == WithoutStorey;
            if (!number || !std::isfinite(*number) || (storey && std::abs(*number) > MostStoreys))
                return reader.mismatch(fmt::format("a number as {}", Columns[i]));
            if (storey)
                row.storey = static_cast<int>(*number);
            else
                (i == 4 ? row.x : row.y) = *number;
        }
        rows.push_back(std::move(row));
    }
    if (const auto failure = reader.failure()) return *failure;
    return rows;
}

}  // namespace leitstand
