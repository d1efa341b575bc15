#include "core/robot/screen_report.h"

#include "core/base/words.h"

namespace leitstand {
namespace {

/// "{0}" is how many packets, grouped; "{1}" is who sent them.
const char* wordsOf(ScreenDrop::Kind kind) {
    using Kind = ScreenDrop::Kind;
    switch (kind) {
        case Kind::NoRtps:
            return translatable("leitstand::ScreenWords",
                                "somebody sends what is no RTPS: {0} packets from {1}");
        case Kind::Numbers:
            return translatable(
                "leitstand::ScreenWords",
                "somebody sends numbers that no writer can have reached: {0} packets from {1}");
        case Kind::Impostor:
            return translatable("leitstand::ScreenWords",
                                "somebody speaks in the name of another participant: {0} packets from {1}");
        case Kind::TooMany:
            return translatable("leitstand::ScreenWords",
                                "more participants or endpoints than a computer may have are refused: {0} "
                                "packets from {1}");
        case Kind::Flood:
            return translatable("leitstand::ScreenWords",
                                "somebody who is no participant sends too much: {0} packets from {1}");
        case Kind::Plain:
            return translatable("leitstand::ScreenWords",
                                "somebody without keys sends what is not encrypted: {0} packets from {1}");
    }
    return "";
}

std::string grouped(std::uint64_t number, const std::string& between) {
    std::string text = fmt::format("{}", number);
    for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, between);
    return text;
}

}  // namespace

std::string toString(const ScreenDrop& drop) {
    return leitstand::fill(wordsOf(drop.kind), grouped(drop.packets, ","),
                           drop.from.empty() ? "many addresses" : drop.from);
}

std::string worded(const ScreenDrop& drop) {
    // The sign between groups of three digits: 1,200.
    const std::string between = translate("leitstand::ScreenWords", ",");
    return leitstand::fill(
        translate("leitstand::ScreenWords", wordsOf(drop.kind)), grouped(drop.packets, between),
        drop.from.empty() ? translate("leitstand::ScreenWords", "many addresses") : drop.from);
}

}  // namespace leitstand
