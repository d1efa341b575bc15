#include <string>

#include "core/io/pad/pad_file.h"
#include "fuzz/input_file.h"

/// Bindings of a gamepad, from a stranger. What was read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto bindings = parsePad(text, "pad.yaml");
    if (!bindings) return fuzz::requireNamed(bindings.error(), "pad.yaml");
    fuzz::require(bindings->commands.size() <= PadBindings::MostCommands, "few commands");
    fuzz::require(bindings->deadZone >= 0.0 && bindings->deadZone <= PadBindings::MostDeadZone,
                  "a dead zone");
    const auto again = parsePad(padText(*bindings, "a pad"), "again");
    fuzz::require(again.ok(), "bindings that can be read again");
    fuzz::require(again->controls == bindings->controls && again->commands == bindings->commands,
                  "the same ones");
    return 0;
}
