#include "core/settings/window_layout.h"

namespace leitstand {

std::vector<std::string> panesIn(const PaneSplit& split) {
    if (!split.pane.empty()) return {split.pane};
    std::vector<std::string> panes;
    for (const PaneSplit& part : split.parts) {
        const auto inner = panesIn(part);
        panes.insert(panes.end(), inner.begin(), inner.end());
    }
    return panes;
}

}  // namespace leitstand
