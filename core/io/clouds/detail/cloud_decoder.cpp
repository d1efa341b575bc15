#include "core/io/clouds/detail/cloud_decoder.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "core/io/detail/numbers.h"

namespace leitstand::detail {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in memory");

constexpr std::size_t ChunkSize = 1 << 18;

template <class T>
double as(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return static_cast<double>(value);
}

double littleEndian(const char* bytes, Scalar type) {
    switch (type) {
        case Scalar::Int8:
            return as<std::int8_t>(bytes);
        case Scalar::UInt8:
            return as<std::uint8_t>(bytes);
        case Scalar::Int16:
            return as<std::int16_t>(bytes);
        case Scalar::UInt16:
            return as<std::uint16_t>(bytes);
        case Scalar::Int32:
            return as<std::int32_t>(bytes);
        case Scalar::UInt32:
            return as<std::uint32_t>(bytes);
        case Scalar::Int64:
            return as<std::int64_t>(bytes);
        case Scalar::UInt64:
            return as<std::uint64_t>(bytes);
        case Scalar::Float32:
            return as<float>(bytes);
        case Scalar::Float64:
            return as<double>(bytes);
    }
    return 0.0;
}

double decoded(const char* bytes, Scalar type, ByteOrder order) {
    if (order == ByteOrder::Little) return littleEndian(bytes, type);
    std::array<char, 8> turned{};
    std::reverse_copy(bytes, bytes + sizeOf(type), turned.begin());
    return littleEndian(turned.data(), type);
}

}  // namespace

CloudDecoder::CloudDecoder(const CloudLayout& layout, Scan& into)
    : m_layout(layout),
      m_sink(into),
      m_fields{layout.find({"x"}), layout.find({"y"}), layout.find({"z"}), layout.intensity(),
               layout.label()} {}

void CloudDecoder::reserve(std::size_t points) {
    m_sink.reserve(points, m_fields[3] != nullptr, m_fields[4] != nullptr);
}

std::optional<std::string_view> CloudDecoder::keep(const Values& values) {
    auto refusal = m_sink.addPoint(values[0], values[1], values[2]);
    if (!refusal && m_fields[3] != nullptr) refusal = m_sink.addIntensity(values[3]);
    if (!refusal && m_fields[4] != nullptr) m_sink.addLabel(values[4]);
    return refusal;
}

Result<void> CloudDecoder::readRecords(InputFile& file, std::uint64_t offset, std::size_t points,
                                       ByteOrder order) {
    if (auto there = file.seek(offset); !there) return there;
    reserve(points);
    const std::size_t size = m_layout.recordSize();
    const std::size_t perChunk = std::clamp<std::size_t>(ChunkSize / size, 1, points);
    std::vector<char> chunk(perChunk * size);
    for (std::size_t done = 0; done < points;) {
        const std::size_t wanted = std::min(perChunk, points - done);
        const auto got = file.read(chunk.data(), wanted * size);
        if (!got) return got.error();
        if (*got < wanted * size) {
            return Error{fmt::format("{}: byte {}: expected {} points, found {}", file.path().string(),
                                     offset + done * size + *got, points, done + *got / size)};
        }
        for (std::size_t i = 0; i < wanted; ++i) {
            Values values{};
            for (std::size_t role = 0; role < Roles; ++role) {
                const CloudField* field = m_fields[role];
                if (field == nullptr) continue;
                values[role] = decoded(chunk.data() + i * size + field->offset, field->type, order);
            }
            if (const auto refusal = keep(values)) {
                return Error{fmt::format("{}: byte {}: expected {}", file.path().string(),
                                         offset + (done + i) * size, *refusal)};
            }
        }
        done += wanted;
    }
    return {};
}

Result<void> CloudDecoder::takeColumns(const std::vector<char>& columns, std::size_t points,
                                       const std::string& file) {
    reserve(points);
    for (std::size_t i = 0; i < points; ++i) {
        Values values{};
        for (std::size_t role = 0; role < Roles; ++role) {
            const CloudField* field = m_fields[role];
            if (field == nullptr) continue;
            const char* column = columns.data() + field->offset * points;
            values[role] = littleEndian(column + i * sizeOf(field->type), field->type);
        }
        if (const auto refusal = keep(values)) {
            return Error{fmt::format("{}: point {}: expected {}", file, i, *refusal)};
        }
    }
    return {};
}

std::optional<std::string> CloudDecoder::takeLine(std::string_view line) {
    Values values{};
    for (std::size_t column = 0; column < m_layout.columns(); ++column) {
        const std::string_view field = takeField(line);
        const auto number = toNumber(field);
        if (!number) return fmt::format("{} numbers", m_layout.columns());
        for (std::size_t role = 0; role < Roles; ++role) {
            if (m_fields[role] != nullptr && m_fields[role]->column == column) values[role] = *number;
        }
    }
    if (!takeField(line).empty()) return fmt::format("{} numbers", m_layout.columns());
    if (const auto refusal = keep(values)) return std::string(*refusal);
    return std::nullopt;
}

Result<void> CloudDecoder::readLines(LineReader& reader, std::size_t points) {
    reserve(points);
    std::string_view line;
    std::size_t found = 0;
    while (found < points && reader.next(line)) {
        if (line.find_first_not_of(" \t") == std::string_view::npos) continue;
        if (const auto expectation = takeLine(line)) return reader.mismatch(*expectation, line);
        ++found;
    }
    if (reader.failure()) return *reader.failure();
    if (found < points) return reader.incomplete(fmt::format("{} points, found {}", points, found));
    return {};
}

void CloudDecoder::finish(const std::string& file, std::vector<std::string>& warnings) {
    m_sink.finish(file, warnings);
}

}  // namespace leitstand::detail
