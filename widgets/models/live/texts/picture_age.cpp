#include "widgets/models/live/texts/picture_age.h"

#include <chrono>

#include "core/base/time.h"

namespace leitstand {

void PictureAge::arrived(std::uint64_t content, SteadyTime now) {
    if (m_content != content) m_change = now;
    m_content = content;
    m_arrival = now;
}

DataAge PictureAge::at(SteadyTime now) const {
    if (!m_content) return {};
    const auto since = [now](SteadyTime then) { return toSeconds(now - then); };
    return {.arrival = since(m_arrival), .content = since(m_change)};
}

}  // namespace leitstand
