#include <string>

#include "core/io/settings/layout_file.h"
#include "fuzz/input_file.h"

/// A layout of the window. What was read can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto layout = parseLayout(text, "layout.yaml");
    if (!layout) return fuzz::requireNamed(layout.error(), "layout.yaml");
    const auto again = parseLayout(writeLayout(*layout), "again");
    fuzz::require(again.ok(), "a layout that can be read again");
    fuzz::require(panesIn(again->panes) == panesIn(layout->panes), "the same panes");
    fuzz::require(again->keys == layout->keys && again->pad == layout->pad, "the same keys");
    fuzz::require(again->title == layout->title && again->arrangement == layout->arrangement,
                  "the same texts");
    return 0;
}
