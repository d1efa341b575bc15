#include "core/perception/pictures/picture_watch.h"

#include <chrono>

#include "core/base/time.h"
#include "core/perception/pictures/content_hash.h"

namespace leitstand {

void PictureWatch::arrived(std::span<const std::byte> bytes, SteadyTime now) {
    const std::uint64_t fingerprint = contentHash(bytes);
    if (m_fingerprint != fingerprint) m_change = now;
    m_fingerprint = fingerprint;
    m_arrival = now;
}

PictureAges PictureWatch::at(SteadyTime now) const {
    if (!m_fingerprint) return {};
    const auto since = [now](SteadyTime then) { return toSeconds(now - then); };
    return {since(m_arrival), since(m_change)};
}

}  // namespace leitstand
