#include "core/io/detail/point_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

namespace {

constexpr std::size_t ShortestPointLine = 6;  // "0 0 0" and its end

struct Grid {
    int rows = 0, columns = 0;
};

std::optional<int> toCount(std::string_view field) {
    int value = 0;
    const char* end = field.data() + field.size();
    const auto parsed = std::from_chars(field.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end || value < 1) return std::nullopt;
    return value;
}

/// "226 x 360" as uos files have it in their first line.
std::optional<Grid> toGrid(std::string_view line) {
    const auto rows = toCount(takeField(line));
    const std::string_view by = takeField(line);
    const auto columns = toCount(takeField(line));
    if (!rows || by != "x" || !columns || !takeField(line).empty()) return std::nullopt;
    return Grid{*rows, *columns};
}

/// Turns lines into points and remembers how many fields the first one had.
class PointLines {
public:
    PointLines(const PointTextFormat& format, PointText& into) : m_format(format), m_text(into) {}

    /// Takes one line; a text says what was expected instead.
    std::optional<std::string> add(std::string_view line) {
        std::array<double, 4> numbers{};
        std::size_t fields = 0;
        while (true) {
            const std::string_view field = takeField(line, m_format.separators);
            if (field.empty()) break;
            if (fields < numbers.size()) {
                const auto number = toNumber(field);
                if (!number) return expectation();
                numbers[fields] = *number;
            }
            ++fields;
        }
        if (fields < 3 || (m_fields != 0 && fields != m_fields)) return expectation();
        m_fields = fields;
        return keep(numbers);
    }

    [[nodiscard]] bool hasIntensities() const { return m_fields > 3; }

private:
    [[nodiscard]] std::string expectation() const {
        if (m_fields <= 3) return "three numbers";
        return fmt::format("{} fields that begin with four numbers", m_fields);
    }

    std::optional<std::string> keep(const std::array<double, 4>& numbers) {
        const Eigen::Vector3d inFile(numbers[0], numbers[1], numbers[2]);
        if (hasIntensities()) {
            if (!std::isfinite(static_cast<float>(numbers[3]))) return "a finite intensity";
            m_text.intensities.push_back(static_cast<float>(numbers[3]));
        }
        if (m_format.zeroIsNoEcho && inFile.isZero(0.0)) {
            m_text.points.push_back(noEcho());
            return std::nullopt;
        }
        const Eigen::Vector3d ours = m_format.toMetres(inFile);
        const auto point = toPoint(ours.x(), ours.y(), ours.z());
        if (!point) return std::string(CoordinateExpectation);
        m_text.points.push_back(*point);
        return std::nullopt;
    }

    const PointTextFormat& m_format;
    PointText& m_text;
    std::size_t m_fields = 0;
};

}  // namespace

Result<PointText> readPointText(const std::filesystem::path& path, const PointTextFormat& format) {
    // Counted first: a vector that grows would hold everything twice.
    const auto lines = countLines(path);
    if (!lines) return lines.error();
    auto opened = LineReader::open(path);
    if (!opened) return opened.error();
    LineReader reader = std::move(opened).value();
    std::error_code ignored;
    const auto mostPoints = std::filesystem::file_size(path, ignored) / ShortestPointLine + 1;
    const std::size_t expected = std::min<std::size_t>(*lines, mostPoints);

    PointText text;
    PointLines points(format, text);
    std::string_view line;
    while (reader.next(line)) {
        std::string_view rest = line;
        const std::string_view first = takeField(rest, format.separators);
        if (first.empty() || first.front() == '#') continue;
        if (format.gridHeader && text.points.empty() && text.rows == 0) {
            if (const auto grid = toGrid(line)) {
                text.rows = grid->rows;
                text.columns = grid->columns;
                continue;
            }
        }
        if (const auto expectation = points.add(line)) return reader.mismatch(*expectation, line);
        if (text.points.size() == 1) {
            text.points.reserve(expected);
            if (points.hasIntensities()) text.intensities.reserve(expected);
        }
    }
    if (reader.failure()) return *reader.failure();
    if (text.points.empty()) return reader.incomplete("points, found none");
    const auto announced = static_cast<std::size_t>(text.rows) * static_cast<std::size_t>(text.columns);
    if (announced != 0 && announced != text.points.size()) {
        return reader.incomplete(fmt::format("{} points ({} x {}), found {}", announced, text.rows,
                                             text.columns, text.points.size()));
    }
    return text;
}

}  // namespace leitstand::detail
