#include "core/io/clouds/detail/point_text.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/detail/point_sink.h"
#include "core/io/clouds/detail/scan_grid.h"
#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

namespace {

constexpr std::size_t ShortestPointLine = 6;  // "0 0 0" and its line end
constexpr std::size_t Nowhere = std::numeric_limits<std::size_t>::max();

/// Parses "226 x 360", the first line of uos files.
std::optional<ScanGrid> toGrid(std::string_view line) {
    const auto rows = toCount(takeField(line));
    const std::string_view by = takeField(line);
    const auto columns = toCount(takeField(line));
    constexpr std::size_t Most = std::numeric_limits<int>::max();
    if (!rows || by != "x" || !columns || !takeField(line).empty()) return std::nullopt;
    if (*rows == 0 || *columns == 0 || *rows > Most || *columns > Most) return std::nullopt;
    return ScanGrid{static_cast<int>(*rows), static_cast<int>(*columns)};
}

bool isComment(std::string_view line) {
    return line.starts_with('#') || line.starts_with("//");
}

/// Turns lines into points and remembers the number of fields of the first one.
class PointLines {
public:
    PointLines(const PointTextFormat& format, Scan& scan) : m_format(format), m_scan(scan), m_sink(scan) {}

    /// Takes one line that is not blank; returns what was expected instead, if anything.
    std::optional<std::string> add(std::string_view line, std::size_t lines) {
        const bool first = m_scan.points.empty();
        if (isComment(line)) {
            if (first && m_format.columnNames) takeNames(line);
            return std::nullopt;
        }
        if (first && m_format.gridHeader && m_scan.rows == 0) {
            if (const auto grid = toGrid(line)) {
                m_scan.rows = grid->rows;
                m_scan.columns = grid->columns;
                return std::nullopt;
            }
        }
        if (auto expectation = addPoint(line)) return expectation;
        if (first) m_sink.reserve(lines, has(m_intensityColumn), has(m_labelColumn));
        return std::nullopt;
    }

    void finish(const std::string& file, std::vector<std::string>& warnings) {
        m_sink.finish(file, warnings);
    }

private:
    [[nodiscard]] bool has(std::size_t column) const { return column < m_fields; }

    void takeNames(std::string_view comment) {
        comment.remove_prefix(std::min(comment.find_first_not_of("#/ \t"), comment.size()));
        std::size_t intensity = Nowhere, label = Nowhere, column = 0;
        for (auto name = takeField(comment, m_format.separators); !name.empty(); ++column) {
            const std::string lower = lowerCase(name);
            if (column < 3 && lower != std::string(1, "xyz"[column])) return;
            if (lower == "intensity" || lower == "reflectance") intensity = column;
            if (lower == "label") label = column;
            name = takeField(comment, m_format.separators);
        }
        if (column < 3) return;
        m_intensityColumn = intensity;
        m_labelColumn = label;
    }

    [[nodiscard]] std::string expectation() const {
        if (m_fields <= 3) return "three numbers";
        return fmt::format("{} fields that begin with numbers", m_fields);
    }

    std::optional<std::string> addPoint(std::string_view line) {
        Eigen::Vector3d inFile;
        double intensity = 0.0, label = 0.0;
        std::size_t fields = 0;
        for (auto field = takeField(line, m_format.separators); !field.empty(); ++fields) {
            double* number = fields < 3                    ? &inFile[static_cast<Eigen::Index>(fields)]
                             : fields == m_intensityColumn ? &intensity
                             : fields == m_labelColumn     ? &label
                                                           : nullptr;
            if (number != nullptr) {
                const auto value = toNumber(field);
                if (!value) return expectation();
                *number = *value;
            }
            field = takeField(line, m_format.separators);
        }
        if (fields < 3 || (m_fields != 0 && fields != m_fields)) return expectation();
        m_fields = fields;
        return keep(inFile, intensity, label);
    }

    std::optional<std::string> keep(const Eigen::Vector3d& inFile, double intensity, double label) {
        const bool dark = m_format.zeroIsNoEcho && inFile.isZero(0.0);
        const Eigen::Vector3d point = dark ? noEcho().cast<double>() : m_format.toMetres(inFile);
        std::optional<std::string_view> refusal = m_sink.addPoint(point.x(), point.y(), point.z());
        if (!refusal && has(m_intensityColumn)) refusal = m_sink.addIntensity(intensity);
        if (!refusal && has(m_labelColumn)) m_sink.addLabel(label);
        return refusal ? std::optional<std::string>(*refusal) : std::nullopt;
    }

    const PointTextFormat& m_format;
    Scan& m_scan;
    PointSink m_sink;
    std::size_t m_fields = 0;
    std::size_t m_intensityColumn = 3, m_labelColumn = Nowhere;
};

}  // namespace

Result<ScanReading> readPointText(const std::filesystem::path& path, const PointTextFormat& format) {
    // Counted first: memory is reserved once.
    const auto lines = countLines(path);
    if (!lines) return lines.error();
    auto opened = LineReader::open(path);
    if (!opened) return opened.error();
    LineReader reader = std::move(opened).value();
    const std::size_t most = std::min<std::size_t>(*lines, reader.fileSize() / ShortestPointLine + 1);

    ScanReading reading;
    Scan& scan = reading.scan;
    scan.name = path.stem().string();
    PointLines points(format, scan);
    std::string_view line;
    while (reader.next(line)) {
        const std::size_t begin = line.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) continue;
        const auto expectation = points.add(line.substr(begin), most);
        if (expectation) return reader.mismatch(*expectation, line);
    }
    if (reader.failure()) return *reader.failure();
    if (scan.points.empty()) return reader.incomplete("points, found none");
    const auto announced = static_cast<std::size_t>(scan.rows) * static_cast<std::size_t>(scan.columns);
    if (announced != 0 && announced != scan.points.size()) {
        return reader.incomplete(fmt::format("{} points ({} x {}), found {}", announced, scan.rows,
                                             scan.columns, scan.points.size()));
    }
    points.finish(path.string(), reading.warnings);
    organise(scan);
    return reading;
}

}  // namespace leitstand::detail
