#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/result.h"
#include "core/io/clouds/detail/cloud_decoder.h"
#include "core/io/clouds/detail/cloud_layout.h"
#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

/// The part of a PLY file's header that describes vertices, checked against the file's size.
struct PlyHeader {
    CloudLayout layout;  ///< layout of a vertex
    std::size_t points = 0;
    int rows = 0, columns = 0;  ///< 0 x 0 when unorganised
    bool text = false;
    ByteOrder order = ByteOrder::Little;
    std::size_t linesBefore = 0;   ///< text only: lines of other elements before the vertices
    std::uint64_t verticesAt = 0;  ///< binary only: first byte of the vertices
};

/// Reads the header, beginning at the first line of the file. Afterwards the reader is right after the
/// header.
[[nodiscard]] Result<PlyHeader> readPlyHeader(LineReader& reader);

}  // namespace leitstand::detail
