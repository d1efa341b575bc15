#include "core/perception/picture_watch.h"

#include <chrono>
#include <functional>
#include <string_view>

namespace leitstand {

void PictureWatch::arrived(std::span<const std::byte> bytes, SteadyTime now) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                                bytes.size());  // bytes may be read as char
    const std::uint64_t fingerprint = std::hash<std::string_view>{}(text);
    if (m_fingerprint != fingerprint) m_change = now;
    m_fingerprint = fingerprint;
    m_arrival = now;
}

PictureAges PictureWatch::at(SteadyTime now) const {
    if (!m_fingerprint) return {};
    const auto since = [now](SteadyTime then) { return std::chrono::duration<double>(now - then).count(); };
    return {since(m_arrival), since(m_change)};
}

}  // namespace leitstand
