#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/result.h"
#include "core/io/clouds/detail/cloud_layout.h"
#include "core/io/clouds/pcd.h"
#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

/// The header of a PCD file, checked against the file's size.
struct PcdHeader {
    CloudLayout layout;
    int width = 0, height = 0;
    std::size_t points = 0;
    PcdEncoding encoding = PcdEncoding::Ascii;
    std::uint64_t bodyOffset = 0;  ///< where the points begin [B]
};

/// Reads the header, beginning at the first line of the file. Afterwards the reader is at the first point.
[[nodiscard]] Result<PcdHeader> readPcdHeader(LineReader& reader);

}  // namespace leitstand::detail
