#include "app/window/panes/camera/picture_looks.h"

namespace leitstand {

void PictureLooks::nextContrast() {
    m_look.contrast = m_look.contrast == ContrastHelp::Off      ? ContrastHelp::Gentle
                      : m_look.contrast == ContrastHelp::Gentle ? ContrastHelp::Strong
                                                                : ContrastHelp::Off;
}

void PictureLooks::setAutoRange(bool on) {
    m_autoRange = on;
    m_ranges.clear();
}

ThermalRange PictureLooks::rangeFor(const std::string& robot, const std::string& sensor,
                                    const ThermalPicture& picture) {
    if (!m_autoRange) return {};
    const ThermalRange now = rangeOf(picture);
    const auto [last, first] = m_ranges.try_emplace({robot, sensor}, now);
    if (!first) last->second = eased(last->second, now);
    return last->second;
}

}  // namespace leitstand
