#include "core/robot/link/screen_report.h"

#include "core/base/words.h"

namespace leitstand {
namespace {

/// "{0}" is how many packets, in words; "{1}" is who sent them.
const char* wordsOf(ScreenDrop::Kind kind) {
    using Kind = ScreenDrop::Kind;
    switch (kind) {
        case Kind::NoRtps:
            return translatable("leitstand::ScreenWords", "somebody sends what is no RTPS: {0} from {1}");
        case Kind::Numbers:
            return translatable("leitstand::ScreenWords",
                                "somebody sends numbers that no writer can have reached: {0} from {1}");
        case Kind::Impostor:
            return translatable("leitstand::ScreenWords",
                                "somebody speaks in the name of another participant: {0} from {1}");
        case Kind::TooMany:
            return translatable(
                "leitstand::ScreenWords",
                "more participants or endpoints than a computer may have are refused: {0} from {1}");
        case Kind::Flood:
            return translatable("leitstand::ScreenWords",
                                "somebody who is no participant sends too much: {0} from {1}");
        case Kind::Plain:
            return translatable("leitstand::ScreenWords",
                                "somebody without keys sends what is not encrypted: {0} from {1}");
    }
    return "";
}

std::string grouped(std::uint64_t number, const std::string& between) {
    std::string text = fmt::format("{}", number);
    for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, between);
    return text;
}

/// @p words translates a text of the program.
template <class Words>
std::string textOf(const ScreenDrop& drop, Words words) {
    const std::string packets =
        leitstand::fill(drop.packets == 1 ? words(translatable("leitstand::ScreenWords", "one packet"))
                                          : words(translatable("leitstand::ScreenWords", "{0} packets")),
                        // The sign between groups of three digits: 1,200.
                        grouped(drop.packets, words(translatable("leitstand::ScreenWords", ","))));
    const std::string from =
        drop.from.empty() ? words(translatable("leitstand::ScreenWords", "many addresses")) : drop.from;
    return leitstand::fill(words(wordsOf(drop.kind)), packets, from);
}

}  // namespace

std::string toString(const ScreenDrop& drop) {
    return textOf(drop, [](const char* text) { return std::string(text); });
}

std::string worded(const ScreenDrop& drop) {
    return textOf(drop, [](const char* text) { return translate("leitstand::ScreenWords", text); });
}

std::string worded(Unscreened what) {
    if (what == Unscreened::SharedMemory)
        return translate(
            "leitstand::ScreenWords",
            "what comes by shared memory is not screened: a program of this computer can bring this "
            "one to a halt (the profile file asks for it)");
    return translate(
        "leitstand::ScreenWords",
        "what comes by TCP is not screened: who can connect can bring this program to a halt (the "
        "profile file asks for it)");
}

std::vector<ScreenDrop> ScreenMessages::due(const std::vector<ScreenDrop>& drops) {
    std::vector<ScreenDrop> due;
    for (const ScreenDrop& drop : drops) {
        std::uint64_t& textOf = m_reported[{drop.kind, drop.from}];
        if (drop.packets == 0 || drop.packets < 10 * textOf) continue;
        textOf = drop.packets;
        due.push_back(drop);
    }
    return due;
}

}  // namespace leitstand
