#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/io/bag/salvage/overlay_file.h"

namespace leitstand::detail {

/// The frames of a write-ahead log of SQLite (https://www.sqlite.org/fileformat2.html, section 4). SQLite
/// reads the log up to the first broken frame; here the frames after it are used as well. The checksum of a
/// frame continues the one that is stored in the previous frame. So the previous frame is enough to verify a
/// frame.
struct LogFrames {
    std::map<std::uint32_t, std::int64_t> pages;  ///< page -> offset of its newest committed content
    std::size_t sound = 0;                        ///< number of valid frames in the log's present round
    std::size_t broken = 0;                       ///< number of frames in the round that are not valid
    /// Number of the first broken frame, from 1; 0: the header is broken, or nothing is.
    std::size_t firstBroken = 0;
    std::size_t hidden = 0;  ///< number of valid committed frames that SQLite does not reach
    bool cut = false;        ///< whether the log ends in a broken frame or within a transaction

    [[nodiscard]] bool hides() const { return hidden > 0; }
};

/// Reads every frame of @p log, whose database has pages of @p pageSize bytes.
[[nodiscard]] LogFrames logFrames(const OverlayFile& log, std::size_t pageSize);

}  // namespace leitstand::detail
