#include "core/station/pad/pad_overlay.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace leitstand {
namespace {

constexpr std::array<std::string_view, standard_button::Count> Names = {"a",
                                                                        "b",
                                                                        "x",
                                                                        "y",
                                                                        "back",
                                                                        "guide",
                                                                        "start",
                                                                        "left_stick",
                                                                        "right_stick",
                                                                        "left_shoulder",
                                                                        "right_shoulder",
                                                                        "up",
                                                                        "down",
                                                                        "left",
                                                                        "right"};
constexpr std::string_view Numbered = "button ";

}  // namespace

std::optional<PadControl> padButtonNamed(const std::string& name, PadLayout layout) {
    const auto known = std::find(Names.begin(), Names.end(), name);
    if (known != Names.end()) {
        if (layout != PadLayout::Standard) return std::nullopt;
        return padButton(static_cast<int>(known - Names.begin()));
    }
    if (!name.starts_with(Numbered)) return std::nullopt;
    int number = 0;
    const char* const end = name.data() + name.size();
    const auto [last, problem] = std::from_chars(name.data() + Numbered.size(), end, number);
    if (problem != std::errc() || last != end || number < 1 || number > PadBindings::MostControls)
        return std::nullopt;
    return padButton(number - 1);
}

PadOverlay withCommands(const PadBindings& own, const std::map<std::string, std::string>& byButton) {
    PadOverlay overlay{own, {}};
    for (const auto& [name, id] : byButton) {
        const auto button = padButtonNamed(name, own.layout);
        const bool acts = button && std::any_of(own.controls.begin(), own.controls.end(),
                                                [&](const PadControl& one) { return one == *button; });
        if (!button || acts || !bindPad(overlay.bindings, id, *button)) overlay.refused.push_back(name);
    }
    return overlay;
}

}  // namespace leitstand
