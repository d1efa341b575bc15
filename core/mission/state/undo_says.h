#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace leitstand {

/// What an undo takes back, or a redo does again.
struct UndoneThing {
    enum class Kind : std::uint8_t {
        Taken,         ///< scans count
        SetAside,      ///< scans do not
        Tried,         ///< scans were registered again
        Crop,          ///< what of the world belongs into the map
        Loop,          ///< the map was brought together where it meets itself
        TidiedMap,     ///< all scans that overlap were put to where they fit each other
        RefusedLoop,   ///< ... or was not: it is another place
        Find,          ///< the newest entry on a find
        ReviewedFind,  ///< likewise, of a review
        ReviewNote,    ///< a note that was written in a review
    };
    Kind kind = Kind::ReviewNote;
    bool again = false;       ///< it is done again
    std::uint64_t scans = 0;  ///< how many scans it is about
    std::uint64_t scan = 0;   ///< id, where it is about one
    std::string find = {};    ///< "V1"
    friend bool operator==(const UndoneThing&, const UndoneThing&) = default;
};

/// @p thing as the log has it (UndoSample::text): "undo: 3 scans set aside", in English.
[[nodiscard]] std::string undoText(const UndoneThing& thing);
/// What undoText() made @p text of; empty: it says something else.
[[nodiscard]] std::optional<UndoneThing> undoneThing(const std::string& text);

}  // namespace leitstand
