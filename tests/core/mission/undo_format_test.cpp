#include "core/mission/state/undo_format.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mission/state/undo.h"

namespace leitstand {
namespace {

using Undone = UndoneThing::Kind;

TEST(UndoSays, WhatIsWrittenIsReadAgain) {
    constexpr std::uint64_t Most = std::numeric_limits<std::uint64_t>::max();
    const std::vector<std::pair<UndoneThing, std::string>> known = {
        {{.kind = Undone::SetAside, .scans = 1, .scan = 7}, "undo: scan 7 set aside"},
        {{.kind = Undone::SetAside, .scans = 12}, "undo: 12 scans set aside"},
        {{.kind = Undone::Taken, .again = true, .scans = 3}, "redo: 3 scans taken"},
        {{.kind = Undone::Taken, .scans = 1, .scan = Most}, "undo: scan 18446744073709551615 taken"},
        {{.kind = Undone::Tried, .scans = 1, .scan = 4}, "undo: scan 4 tried"},
        {{.kind = Undone::Tried, .again = true, .scans = 2}, "redo: 2 scans tried"},
        {{.kind = Undone::Crop}, "undo: what belongs into the map"},
        {{.kind = Undone::Crop, .again = true}, "redo: what belongs into the map"},
        {{.kind = Undone::Loop}, "undo: a closed loop"},
        {{.kind = Undone::TidiedMap}, "undo: the tidied map"},
        {{.kind = Undone::RefusedLoop}, "undo: a place told from another"},
        {{.kind = Undone::Loop, .again = true}, "redo: a closed loop"},
        {{.kind = Undone::Find, .find = "H12"}, "undo: H12"},
        {{.kind = Undone::ReviewedFind, .find = "V1"}, "V1 as corrected in a review"},
        {{.kind = Undone::ReviewNote}, "a note of a review"},
    };
    for (const auto& [thing, text] : known) {
        EXPECT_EQ(undoneThing(undoText(thing)), thing) << undoText(thing);
        EXPECT_EQ(undoneThing(text), thing) << "as logs of before have it: " << text;
    }
    EXPECT_EQ(undoText(known[0].first), "undo what=set_aside scans=1 scan=7");
    EXPECT_EQ(undoText(known[2].first), "redo what=taken scans=3");
    EXPECT_EQ(undoText(known[12].first), "undo what=find find=H12");
}

TEST(UndoSays, WhatSomebodyElseWroteIsNotUnderstood) {
    for (const char* const text : {"",
                                   "undo",
                                   "undo: ",
                                   "redo: ",
                                   "undo: undo: V1",
                                   "V1",
                                   "undo: V",
                                   "undo: V01",
                                   "undo: X1",
                                   "undo: V1 ",
                                   "undo: V4294967296",
                                   "undo: scan 7",
                                   "undo: scan  taken",
                                   "undo: scan 007 taken",
                                   "undo: scan -1 taken",
                                   "undo: scan 7 taken away",
                                   "undo: scan 1 scans taken",
                                   "undo: 1 scans taken",
                                   "undo: many scans taken",
                                   "undo: 99999999999999999999 scans taken",
                                   "undo: scan {} taken",
                                   "undo: {} scans tried",
                                   "undo: {}",
                                   "{} as corrected in a review",
                                   "scan 7 taken",
                                   "undo: a note of a review",
                                   "redo: V1 as corrected in a review",
                                   "door as corrected in a review",
                                   "undo: was im Bild ist",
                                   "undo what=",
                                   "undo what=everything",
                                   "undo what=find",
                                   "undo what=find find=door",
                                   "undo what=taken scans=01",
                                   "undo what=taken scans=1",
                                   "undo what=taken scans=2 scan=9",
                                   "undo scans=2 what=taken",
                                   "undo what=taken scans=\"2"})
        EXPECT_EQ(undoneThing(text), std::nullopt) << '"' << text << '"';
}

TEST(UndoSays, ADecisionOnTheMapIsTheSameThingWhoeverTellsIt) {
    using Decided = MapDecision::Kind;
    EXPECT_EQ(undoneThing(MapDecision{Decided::Tried, {9}, 3}),
              (UndoneThing{.kind = Undone::Tried, .scans = 1, .scan = 9}));
    EXPECT_EQ(undoneThing(MapDecision{Decided::Taken, {9, 11}, 3}),
              (UndoneThing{.kind = Undone::Taken, .scans = 2}));
    EXPECT_EQ(undoneThing(MapDecision{Decided::Crop, {}, 3}), UndoneThing{.kind = Undone::Crop});
}

}  // namespace
}  // namespace leitstand
