#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace leitstand {

/// What an undo takes back, or a redo does again.
struct UndoneThing {
    enum class Kind : std::uint8_t {
        Taken,         ///< scans count
        SetAside,      ///< scans do not count
        Tried,         ///< scans were registered again
        Crop,          ///< the area that belongs to the map
        Loop,          ///< the map was joined where it meets itself
        TidiedMap,     ///< all overlapping scans were moved to where they fit each other
        RefusedLoop,   ///< the map was not joined where it seems to meet itself
        Find,          ///< the newest entry on a find
        ReviewedFind,  ///< the newest entry on a find in a review
        ReviewNote,    ///< a note that was written in a review
    };
    Kind kind = Kind::ReviewNote;
    bool again = false;       ///< a redo, not an undo
    std::uint64_t scans = 0;  ///< how many scans it is about
    std::uint64_t scan = 0;   ///< id of the scan, when scans is 1
    std::string find = {};    ///< "V1"
    friend bool operator==(const UndoneThing&, const UndoneThing&) = default;
};

/// Returns @p thing as the log holds it (UndoSample::text): "undo what=set_aside scans=3".
[[nodiscard]] std::string undoText(const UndoneThing& thing);
/// Returns the thing for which undoText() made @p text; empty: it is another text. Also reads the English
/// sentences of old logs, written before there were codes.
[[nodiscard]] std::optional<UndoneThing> undoneThing(const std::string& text);

}  // namespace leitstand
