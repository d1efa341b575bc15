#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/result.h"
#include "core/io/clouds/detail/cloud_decoder.h"
#include "core/io/clouds/detail/cloud_layout.h"
#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

/// The header of a PLY file as far as vertices go, checked against the file's size.
struct PlyHeader {
    CloudLayout layout;  ///< of a vertex
    std::size_t points = 0;
    int rows = 0, columns = 0;  ///< 0 x 0 when unorganised
    bool text = false;
    ByteOrder order = ByteOrder::Little;
    std::size_t linesBefore = 0;   ///< of other elements before the vertices, where text
    std::uint64_t verticesAt = 0;  ///< first byte of the vertices, where binary
};

/// Reads the header from the first line on; the reader then stands behind it.
[[nodiscard]] Result<PlyHeader> readPlyHeader(LineReader& reader);

}  // namespace leitstand::detail
