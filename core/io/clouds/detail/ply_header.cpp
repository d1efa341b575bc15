#include "core/io/clouds/detail/ply_header.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

namespace {

constexpr std::size_t MaxHeaderLines = 1000;

struct Element {
    std::string name;
    std::size_t count = 0;
    CloudLayout layout;
    bool hasLists = false;  // the size is unknown then
};

std::optional<Scalar> toScalar(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, Scalar>, 16> Names = {{
        {"char", Scalar::Int8},
        {"int8", Scalar::Int8},
        {"uchar", Scalar::UInt8},
        {"uint8", Scalar::UInt8},
        {"short", Scalar::Int16},
        {"int16", Scalar::Int16},
        {"ushort", Scalar::UInt16},
        {"uint16", Scalar::UInt16},
        {"int", Scalar::Int32},
        {"int32", Scalar::Int32},
        {"uint", Scalar::UInt32},
        {"uint32", Scalar::UInt32},
        {"float", Scalar::Float32},
        {"float32", Scalar::Float32},
        {"double", Scalar::Float64},
        {"float64", Scalar::Float64},
    }};
    for (const auto& [known, scalar] : Names) {
        if (known == name) return scalar;
    }
    return std::nullopt;
}

/// Collects the entries of a header.
class PlyEntries {
public:
    /// Takes a line after "ply"; returns what was expected instead, if anything.
    std::optional<std::string> take(std::string_view line) {
        const std::string_view keyword = takeField(line);
        if (keyword == "comment") return std::nullopt;
        if (keyword == "format") return takeFormat(line);
        if (keyword == "obj_info") return takeInfo(line);
        if (keyword == "element") return takeElement(line);
        if (keyword == "property") return takeProperty(line);
        if (keyword != "end_header")
            return "an entry of a PLY header (format, element, property, end_header)";
        m_complete = true;
        return std::nullopt;
    }

    [[nodiscard]] bool complete() const { return m_complete; }

    /// Composes the header from the entries; returns what was expected in them, if anything.
    std::optional<std::string> compose(PlyHeader& header) const {
        if (!m_format) return "a format";
        header.text = *m_format == "ascii";
        header.order = *m_format == "binary_big_endian" ? ByteOrder::Big : ByteOrder::Little;
        const auto vertex = std::find_if(m_elements.begin(), m_elements.end(),
                                         [](const Element& element) { return element.name == "vertex"; });
        if (vertex == m_elements.end() || vertex->count == 0) return "vertices, found none";
        if (vertex->count > std::numeric_limits<int>::max()) return "fewer than 2^31 vertices";
        if (vertex->hasLists) return "vertices without lists";
        if (!vertex->layout.hasPoints()) return "vertices with x, y and z";
        for (auto before = m_elements.begin(); before != vertex; ++before) {
            if (!header.text && before->hasLists) return "no lists before the vertices";
            if (before->count > std::numeric_limits<int>::max()) return "fewer than 2^31 elements";
            header.linesBefore += before->count;
            header.verticesAt += before->count * before->layout.recordSize();
        }
        header.layout = vertex->layout;
        header.points = vertex->count;
        if (m_rows > 1 && m_columns > 0 && vertex->count / m_columns == m_rows &&
            vertex->count % m_columns == 0) {
            header.rows = static_cast<int>(m_rows);
            header.columns = static_cast<int>(m_columns);
        }
        return std::nullopt;
    }

private:
    std::optional<std::string> takeFormat(std::string_view line) {
        const std::string_view name = takeField(line);
        const bool known = name == "ascii" || name == "binary_little_endian" || name == "binary_big_endian";
        if (!known || takeField(line) != "1.0")
            return "format ascii, binary_little_endian or binary_big_endian 1.0";
        m_format = name;
        return std::nullopt;
    }

    std::optional<std::string> takeInfo(std::string_view line) {
        const std::string_view key = takeField(line);
        const auto number = toCount(takeField(line));
        if (key == "num_cols") m_columns = number.value_or(0);
        if (key == "num_rows") m_rows = number.value_or(0);
        return std::nullopt;
    }

    std::optional<std::string> takeElement(std::string_view line) {
        const std::string_view name = takeField(line);
        const auto count = toCount(takeField(line));
        if (name.empty() || !count) return "element NAME COUNT";
        m_elements.push_back({std::string(name), *count, {}});
        return std::nullopt;
    }

    std::optional<std::string> takeProperty(std::string_view line) {
        if (m_elements.empty()) return "an element before its properties";
        const std::string_view type = takeField(line);
        if (type == "list") {
            m_elements.back().hasLists = true;
            return std::nullopt;
        }
        const auto scalar = toScalar(type);
        const std::string_view name = takeField(line);
        if (!scalar || name.empty()) return "property TYPE NAME";
        if (!m_elements.back().layout.add(std::string(name), *scalar)) return "elements of at most 256 KiB";
        return std::nullopt;
    }

    std::optional<std::string> m_format;
    std::vector<Element> m_elements;
    std::size_t m_rows = 0, m_columns = 0;
    bool m_complete = false;
};

}  // namespace

Result<PlyHeader> readPlyHeader(LineReader& reader) {
    std::string_view line;
    if (!reader.next(line) || line != "ply") {
        if (reader.failure()) return *reader.failure();
        return reader.incomplete("a PLY file that begins with \"ply\"");
    }
    PlyEntries entries;
    while (!entries.complete() && reader.next(line)) {
        if (reader.lineNumber() > MaxHeaderLines) break;
        if (const auto expectation = entries.take(line)) return reader.mismatch(*expectation, line);
    }
    if (reader.failure()) return *reader.failure();
    if (!entries.complete()) return reader.incomplete("a PLY header that ends in end_header");
    PlyHeader header;
    if (const auto expectation = entries.compose(header)) {
        return reader.incomplete("in the header " + *expectation);
    }
    header.verticesAt += reader.bytesTaken();
    const std::uint64_t begin = header.text ? reader.bytesTaken() : header.verticesAt;
    const std::uint64_t body = reader.fileSize() - std::min(reader.fileSize(), begin);
    const std::uint64_t least = header.text ? header.points * 2 * header.layout.columns() - 1
                                            : header.points * header.layout.recordSize();
    if (least > body) {
        return reader.incomplete(
            fmt::format("{} vertices, which take at least {} bytes, found {} from byte {} on", header.points,
                        least, body, begin));
    }
    return header;
}

}  // namespace leitstand::detail
