#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/io/bag/salvage/overlay_file.h"

namespace leitstand::detail {

/// What a write-ahead log of SQLite holds (https://www.sqlite.org/fileformat2.html, section 4). SQLite reads
/// it up to the first frame that is broken; here those behind it count too. Each frame's checksum goes on
/// from that of the frame before, which stands in that frame, so a frame is known to be sound without those
/// before.
struct LogFrames {
    std::map<std::uint32_t, std::int64_t> pages;  ///< page -> offset of its newest committed content
    std::size_t sound = 0;                        ///< frames of the log's present round
    std::size_t broken = 0;                       ///< frames that belong to it and are not sound
    std::size_t firstBroken = 0;                  ///< its place, from 1; 0: the header is broken
    std::size_t hidden = 0;                       ///< committed sound frames that SQLite does not come to
    bool cut = false;                             ///< it ends in a broken frame or within a transaction

    [[nodiscard]] bool hides() const { return hidden > 0; }
};

/// Looks at every frame of @p log, whose database has pages of @p pageSize bytes.
[[nodiscard]] LogFrames logFrames(const OverlayFile& log, std::size_t pageSize);

}  // namespace leitstand::detail
