#include "core/mission/state/undo_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <string_view>

#include "core/base/phrases/coded_text.h"
#include "core/event/find_sample.h"

namespace leitstand {
namespace {

using Thing = UndoneThing::Kind;

constexpr std::string_view UndoPrefix = "undo: ", RedoPrefix = "redo: ";

struct UndoCode {
    Thing kind;
    const char* code;
};
constexpr UndoCode Codes[] = {
    {Thing::Taken, "taken"},
    {Thing::SetAside, "set_aside"},
    {Thing::Tried, "tried"},
    {Thing::Crop, "crop"},
    {Thing::Loop, "loop"},
    {Thing::TidiedMap, "tidied_map"},
    {Thing::RefusedLoop, "refused_loop"},
    {Thing::Find, "find"},
    {Thing::ReviewedFind, "reviewed_find"},
    {Thing::ReviewNote, "review_note"},
};

struct UndoSentence {
    Thing kind;
    bool oneScan;
    const char* words;
};
/// Of logs from before there were codes; the most special first.
constexpr auto UndoSentences = std::to_array<UndoSentence>({
    {Thing::Taken, true, "scan {} taken"},
    {Thing::Taken, false, "{} scans taken"},
    {Thing::SetAside, true, "scan {} set aside"},
    {Thing::SetAside, false, "{} scans set aside"},
    {Thing::Tried, true, "scan {} tried"},
    {Thing::Tried, false, "{} scans tried"},
    {Thing::Crop, false, "what belongs into the map"},
    {Thing::Loop, false, "a closed loop"},
    {Thing::TidiedMap, false, "the tidied map"},
    {Thing::RefusedLoop, false, "a place told from another"},
    {Thing::ReviewNote, false, "a note of a review"},
    {Thing::ReviewedFind, false, "{} as corrected in a review"},
    {Thing::Find, false, "{}"},
});
constexpr auto UndoWords = [] {
    std::array<const char*, UndoSentences.size()> words{};
    std::transform(UndoSentences.begin(), UndoSentences.end(), words.begin(),
                   [](const UndoSentence& one) { return one.words; });
    return words;
}();

bool isOnScans(Thing kind) {
    return kind == Thing::Taken || kind == Thing::SetAside || kind == Thing::Tried;
}

bool isOfReview(Thing kind) {
    return kind == Thing::ReviewedFind || kind == Thing::ReviewNote;
}

bool isOnFind(Thing kind) {
    return kind == Thing::Find || kind == Thing::ReviewedFind;
}

/// Returns the number that @p digits begin with; 0: there is none.
template <class Number>
Number numberIn(std::string_view digits) {
    Number number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

bool isFindName(const std::string& name) {
    using Find = FindSample::Kind;
    const auto number =
        numberIn<std::uint32_t>(std::string_view(name).substr(std::min<std::size_t>(1, name.size())));
    const auto kinds = {Find::Victim, Find::Hazard, Find::Code, Find::Object};
    return std::any_of(kinds.begin(), kinds.end(), [&](Find kind) { return nameOf(kind, number) == name; });
}

std::string oldText(const UndoneThing& thing) {
    const bool one = thing.scans == 1;
    const auto* const sentence =
        std::find_if(UndoSentences.begin(), UndoSentences.end(), [&](const UndoSentence& known) {
            return known.kind == thing.kind && known.oneScan == (isOnScans(thing.kind) && one);
        });
    const std::string value =
        isOnScans(thing.kind) ? std::to_string(one ? thing.scan : thing.scans) : thing.find;
    const std::string_view before = isOfReview(thing.kind) ? "" : thing.again ? RedoPrefix : UndoPrefix;
    return std::string(before) + withValues(sentence->words, {value});
}

/// Reads the English sentences of logs from before there were codes.
std::optional<UndoneThing> oldThing(const std::string& text) {
    UndoneThing thing;
    std::string_view rest = text;
    thing.again = rest.starts_with(RedoPrefix);
    if (thing.again || rest.starts_with(UndoPrefix)) rest.remove_prefix(UndoPrefix.size());
    const KnownSentence reported = knownSentence(rest, UndoWords);
    const auto* const sentence =
        std::find_if(UndoSentences.begin(), UndoSentences.end(),
                     [&reported](const UndoSentence& known) { return known.words == reported.words; });
    if (sentence == UndoSentences.end()) return std::nullopt;
    thing.kind = sentence->kind;
    const std::string value = reported.values.empty() ? std::string() : reported.values.front();
    if (isOnScans(thing.kind)) {
        const auto number = numberIn<std::uint64_t>(value);
        thing.scans = sentence->oneScan ? 1 : number;
        if (sentence->oneScan) thing.scan = number;
    } else if (!value.empty()) {
        if (!isFindName(value)) return std::nullopt;
        thing.find = value;
    }
    // Nothing wrote "scan 007 taken" or "1 scans taken".
    if (oldText(thing) != text) return std::nullopt;
    return thing;
}

std::optional<UndoneThing> codedThing(const std::string& text) {
    const auto coded = codedText(text);
    if (!coded) return std::nullopt;
    const auto what = coded->value("what");
    const auto* const code =
        std::ranges::find_if(Codes, [&](const UndoCode& one) { return what == std::string(one.code); });
    if (code == std::end(Codes)) return std::nullopt;
    UndoneThing thing{.kind = code->kind, .again = coded->code == "redo"};
    thing.scans = numberIn<std::uint64_t>(coded->value("scans").value_or("0"));
    thing.scan = numberIn<std::uint64_t>(coded->value("scan").value_or("0"));
    thing.find = coded->value("find").value_or(std::string());
    if (isOnFind(thing.kind) && !isFindName(thing.find)) return std::nullopt;
    if (undoText(thing) != text) return std::nullopt;
    return thing;
}

}  // namespace

std::string undoText(const UndoneThing& thing) {
    CodedText coded{thing.again ? "redo" : "undo", {}};
    coded.values.emplace_back("what", std::ranges::find(Codes, thing.kind, &UndoCode::kind)->code);
    if (isOnScans(thing.kind)) coded.values.emplace_back("scans", std::to_string(thing.scans));
    if (isOnScans(thing.kind) && thing.scans == 1)
        coded.values.emplace_back("scan", std::to_string(thing.scan));
    if (isOnFind(thing.kind)) coded.values.emplace_back("find", thing.find);
    return toString(coded);
}

std::optional<UndoneThing> undoneThing(const std::string& text) {
    return text.starts_with("undo ") || text.starts_with("redo ") ? codedThing(text) : oldThing(text);
}

}  // namespace leitstand
