#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace leitstand {

/// What an undo or a redo is about.
struct UndoneThing {
    enum class Kind : std::uint8_t {
        Taken,         ///< scans were accepted
        SetAside,      ///< scans were set aside
        Tried,         ///< scans were registered again
        Crop,          ///< the area that belongs to the map was set
        Loop,          ///< the map was joined at a place that was mapped twice
        TidiedMap,     ///< all overlapping scans were moved to where they fit each other
        RefusedLoop,   ///< the map was not joined at a possible loop
        Find,          ///< newest entry about a find
        ReviewedFind,  ///< newest entry about a find, made in a review
        ReviewNote,    ///< note that was written in a review
    };
    Kind kind = Kind::ReviewNote;
    bool again = false;       ///< whether it is a redo
    std::uint64_t scans = 0;  ///< number of scans
    std::uint64_t scan = 0;   ///< id of the scan if `scans` is 1
    std::string find = {};    ///< name of the find, "V1"
    friend bool operator==(const UndoneThing&, const UndoneThing&) = default;
};

/// Returns @p thing in the form for the log (UndoSample::text): "undo what=set_aside scans=3".
[[nodiscard]] std::string undoText(const UndoneThing& thing);
/// Parses a @p text of undoText(); empty: it is another text. Also reads the English sentences of old logs,
/// from before there were codes.
[[nodiscard]] std::optional<UndoneThing> undoneThing(const std::string& text);

}  // namespace leitstand
