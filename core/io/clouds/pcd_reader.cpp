#include "core/io/clouds/pcd.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <lzf.h>

#include "core/io/clouds/detail/cloud_decoder.h"
#include "core/io/clouds/detail/pcd_header.h"
#include "core/io/clouds/detail/scan_grid.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t BestCompression = 264;  // LZF never expands a byte to more

/// Decompresses the body: the fields of all points, one field after another.
Result<std::vector<char>> decompressed(detail::InputFile& file, const detail::PcdHeader& header) {
    const auto at = [&](std::uint64_t offset, const std::string& text) {
        return Error{fmt::format("{}: byte {}: expected {}", file.path().string(), offset, text)};
    };
    if (auto there = file.seek(header.bodyOffset); !there) return there.error();
    std::uint32_t sizes[2] = {};  // compressed, then decompressed
    std::array<char, sizeof(sizes)> bytes;
    const auto got = file.read(bytes.data(), bytes.size());
    if (!got) return got.error();
    if (*got != bytes.size()) return at(header.bodyOffset, "the sizes of the compressed points");
    std::memcpy(sizes, bytes.data(), sizeof(sizes));
    const std::uint64_t start = header.bodyOffset + bytes.size();
    const std::uint64_t expected = header.points * header.layout.recordSize();
    if (sizes[1] != expected) {
        return at(header.bodyOffset + 4, fmt::format("{} decompressed bytes, found {}", expected, sizes[1]));
    }
    if (sizes[0] > file.size() - start || sizes[1] > sizes[0] * BestCompression) {
        return at(header.bodyOffset,
                  fmt::format("{} compressed bytes, found {}", sizes[0], file.size() - start));
    }
    std::vector<char> packed(sizes[0]);
    if (const auto read = file.read(packed.data(), packed.size()); !read) return read.error();
    std::vector<char> unpacked(sizes[1]);
    if (lzf_decompress(packed.data(), sizes[0], unpacked.data(), sizes[1]) != sizes[1]) {
        return at(start, "points compressed by LZF");
    }
    return unpacked;
}

Result<void> readCompressed(detail::CloudDecoder& decoder, detail::InputFile& file,
                            const detail::PcdHeader& header) {
    const auto columns = decompressed(file, header);
    if (!columns) return columns.error();
    return decoder.takeColumns(*columns, header.points, file.path().string());
}

Result<void> readBody(detail::CloudDecoder& decoder, detail::LineReader& reader, const fs::path& path,
                      const detail::PcdHeader& header) {
    if (header.encoding == PcdEncoding::Ascii) return decoder.readLines(reader, header.points);
    auto opened = detail::InputFile::open(path);
    if (!opened) return opened.error();
    detail::InputFile file = std::move(opened).value();
    if (header.encoding == PcdEncoding::BinaryCompressed) return readCompressed(decoder, file, header);
    return decoder.readRecords(file, header.bodyOffset, header.points, detail::ByteOrder::Little);
}

}  // namespace

// PCL's own readers hold a cloud twice, read text as the number 0, and print. Only the LZF of pcl_io is used.
Result<ScanReading> readPcd(const fs::path& path) {
    auto opened = detail::LineReader::open(path);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    const auto header = detail::readPcdHeader(reader);
    if (!header) return header.error();

    ScanReading reading;
    Scan& scan = reading.scan;
    scan.name = path.stem().string();
    if (header->height > 1) {
        scan.rows = header->height;
        scan.columns = header->width;
    }
    detail::CloudDecoder decoder(header->layout, scan);
    if (auto body = readBody(decoder, reader, path, *header); !body) return body.error();
    decoder.finish(path.string(), reading.warnings);
    detail::organise(scan);
    return reading;
}

}  // namespace leitstand
