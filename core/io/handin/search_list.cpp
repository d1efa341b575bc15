#include "core/io/handin/search_list.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"
#include "core/io/handin/csv_fields.h"

namespace leitstand {
namespace {

constexpr std::array<std::string_view, 6> Columns = {"sensor", "what", "m2", "percent", "x", "y"};

}  // namespace

Result<void> writeSearchList(const std::filesystem::path& file, const std::vector<ListedSearch>& rows) {
    std::string text = fmt::format("{}\n", fmt::join(Columns, ","));
    for (const ListedSearch& row : rows) {
        const bool placed = row.what == "missed";
        if (!std::isfinite(row.area) || !std::isfinite(row.share) || !std::isfinite(row.x + row.y))
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: is not written: a figure of {} is no number"),
                file.string(), row.sensor)};
        text += fmt::format("{},{},{:.2f},{:.1f},{},{}\n", csvField(row.sensor), csvField(row.what), row.area,
                            100.0 * row.share, placed ? fmt::format("{:.2f}", row.x) : "",
                            placed ? fmt::format("{:.2f}", row.y) : "");
    }
    return detail::writeWhole(file, text);
}

Result<std::vector<ListedSearch>> readSearchList(const std::filesystem::path& file) {
    auto opened = CsvReader::open(file);
    if (!opened) return opened.error();
    CsvReader reader = std::move(opened).value();
    std::vector<std::string> fields;
    if (!reader.next(fields) || !std::equal(fields.begin(), fields.end(), Columns.begin(), Columns.end())) {
        if (const auto failure = reader.failure()) return *failure;
        return reader.mismatch(fmt::format("the columns {}", fmt::join(Columns, ",")));
    }
    std::vector<ListedSearch> rows;
    while (reader.next(fields)) {
        if (fields.size() == 1 && fields.front().empty()) continue;
        if (fields.size() != Columns.size()) return reader.mismatch("six fields");
        ListedSearch row;
        row.sensor = fields[0];
        row.what = fields[1];
        const auto area = detail::toNumber(fields[2]), percent = detail::toNumber(fields[3]);
        if (!area || !std::isfinite(*area) || *area < 0.0) return reader.mismatch("an area as m2");
        if (!percent || !std::isfinite(*percent)) return reader.mismatch("a number as percent");
        row.area = *area;
        row.share = *percent / 100.0;
        for (std::size_t i = 4; i < 6; ++i) {
            if (fields[i].empty()) continue;
            const auto number = detail::toNumber(fields[i]);
            if (!number || !std::isfinite(*number))
                return reader.mismatch(fmt::format("a number as {}", Columns[i]));
            (i == 4 ? row.x : row.y) = *number;
        }
        rows.push_back(std::move(row));
    }
    if (const auto failure = reader.failure()) return *failure;
    return rows;
}

}  // namespace leitstand
