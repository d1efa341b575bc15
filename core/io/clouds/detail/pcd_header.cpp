#include "core/io/clouds/detail/pcd_header.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

namespace {

constexpr std::size_t MaxHeaderLines = 100;

std::optional<Scalar> toScalar(std::string_view type, std::size_t size) {
    const bool real = type == "F", whole = type == "I", natural = type == "U";
    if (real && size == 4) return Scalar::Float32;
    if (real && size == 8) return Scalar::Float64;
    if (!whole && !natural) return std::nullopt;
    switch (size) {
        case 1:
            return whole ? Scalar::Int8 : Scalar::UInt8;
        case 2:
            return whole ? Scalar::Int16 : Scalar::UInt16;
        case 4:
            return whole ? Scalar::Int32 : Scalar::UInt32;
        case 8:
            return whole ? Scalar::Int64 : Scalar::UInt64;
        default:
            return std::nullopt;
    }
}

/// Collects the entries of a header; their order is free until DATA.
class PcdEntries {
public:
    /// Takes a line; returns what was expected instead, if anything.
    std::optional<std::string> take(std::string_view line) {
        const std::string_view keyword = takeField(line);
        if (keyword == "FIELDS" || keyword == "COLUMNS") return takeWords(line, m_names);
        if (keyword == "TYPE") return takeWords(line, m_types);
        if (keyword == "SIZE") return takeCounts(line, m_sizes);
        if (keyword == "COUNT") return takeCounts(line, m_counts);
        if (keyword == "WIDTH") return takeNumber(line, m_width);
        if (keyword == "HEIGHT") return takeNumber(line, m_height);
        if (keyword == "POINTS") return takeNumber(line, m_points);
        if (keyword == "DATA") return takeEncoding(line);
        if (keyword == "VERSION" || keyword == "VIEWPOINT") return std::nullopt;
        return "an entry of a PCD header (FIELDS, SIZE, TYPE, WIDTH, ..., DATA)";
    }

    [[nodiscard]] bool complete() const { return m_encoding.has_value(); }

    /// Composes the header from the entries; returns what was expected in them, if anything.
    std::optional<std::string> compose(PcdHeader& header) const {
        if (m_names.empty() || m_names.size() != m_sizes.size() || m_names.size() != m_types.size() ||
            (!m_counts.empty() && m_names.size() != m_counts.size())) {
            return "as many SIZE, TYPE and COUNT as FIELDS";
        }
        for (std::size_t i = 0; i < m_names.size(); ++i) {
            const auto type = toScalar(m_types[i], m_sizes[i]);
            if (!type) return fmt::format("a known type of field \"{}\"", quotable(m_names[i]));
            const std::size_t count = m_counts.empty() ? 1 : m_counts[i];
            if (!header.layout.add(m_names[i], *type, count)) return "points of at most 256 KiB";
        }
        if (!header.layout.hasPoints()) return "fields x, y and z";
        constexpr std::size_t Most = std::numeric_limits<int>::max();
        const std::size_t height = m_height.value_or(1);
        if (!m_width || *m_width > Most || height > Most) return "WIDTH and HEIGHT below 2^31";
        if (*m_width * height > Most) return "fewer than 2^31 points";
        header.width = static_cast<int>(*m_width);
        header.height = static_cast<int>(height);
        header.points = *m_width * height;
        if (m_points && *m_points != header.points) {
            return fmt::format("POINTS to be WIDTH x HEIGHT = {}, found {}", header.points, *m_points);
        }
        if (header.points == 0) return "points, found none";
        header.encoding = *m_encoding;
        return std::nullopt;
    }

private:
    static std::optional<std::string> takeWords(std::string_view line, std::vector<std::string>& words) {
        words.clear();
        for (auto word = takeField(line); !word.empty(); word = takeField(line)) words.emplace_back(word);
        return words.empty() ? std::optional<std::string>("at least one field") : std::nullopt;
    }

    static std::optional<std::string> takeCounts(std::string_view line, std::vector<std::size_t>& counts) {
        counts.clear();
        for (auto word = takeField(line); !word.empty(); word = takeField(line)) {
            const auto count = toCount(word);
            if (!count || *count == 0) return "whole numbers from 1 on";
            counts.push_back(*count);
        }
        return std::nullopt;
    }

    static std::optional<std::string> takeNumber(std::string_view line, std::optional<std::size_t>& number) {
        number = toCount(takeField(line));
        return number ? std::nullopt : std::optional<std::string>("a whole number from 0 on");
    }

    std::optional<std::string> takeEncoding(std::string_view line) {
        const std::string_view word = takeField(line);
        if (word == "ascii") m_encoding = PcdEncoding::Ascii;
        if (word == "binary") m_encoding = PcdEncoding::Binary;
        if (word == "binary_compressed") m_encoding = PcdEncoding::BinaryCompressed;
        if (m_encoding) return std::nullopt;
        return "DATA ascii, binary or binary_compressed";
    }

    std::vector<std::string> m_names, m_types;
    std::vector<std::size_t> m_sizes, m_counts;
    std::optional<std::size_t> m_width, m_height, m_points;
    std::optional<PcdEncoding> m_encoding;
};

/// Returns the fewest bytes that the body must have; a compressed body contains its own size.
std::uint64_t leastBody(const PcdHeader& header) {
    switch (header.encoding) {
        case PcdEncoding::Ascii:
            return header.points * (2 * header.layout.columns()) - 1;
        case PcdEncoding::Binary:
            return header.points * header.layout.recordSize();
        case PcdEncoding::BinaryCompressed:
            return 2 * sizeof(std::uint32_t);
    }
    return 0;
}

}  // namespace

Result<PcdHeader> readPcdHeader(LineReader& reader) {
    PcdEntries entries;
    std::string_view line;
    while (!entries.complete() && reader.next(line)) {
        if (reader.lineNumber() > MaxHeaderLines) break;
        std::string_view rest = line;
        const std::string_view first = takeField(rest);
        if (first.empty() || first.front() == '#') continue;
        if (const auto expectation = entries.take(line)) return reader.mismatch(*expectation, line);
    }
    if (reader.failure()) return *reader.failure();
    if (!entries.complete()) return reader.incomplete("a PCD header that ends in DATA");
    PcdHeader header;
    if (const auto expectation = entries.compose(header)) {
        return reader.incomplete("in the header " + *expectation);
    }
    header.bodyOffset = reader.bytesTaken();
    const std::uint64_t body = reader.fileSize() - std::min(reader.fileSize(), header.bodyOffset);
    if (leastBody(header) > body) {
        return reader.incomplete(
            fmt::format("{} points, which take at least {} bytes, found {} from byte {} on", header.points,
                        leastBody(header), body, header.bodyOffset));
    }
    return header;
}

}  // namespace leitstand::detail
