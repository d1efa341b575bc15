#pragma once

#include "transport/screen/cursor.h"
#include "transport/screen/datagram.h"

namespace leitstand::screen {

/// Checks the order and sizes of secure submessages in a datagram (DDS-Security 1.1, section 7.3.6). A whole
/// message stands between SRTPS_PREFIX, the first, and SRTPS_POSTFIX, the last but for statistics. A single
/// submessage stands between SEC_PREFIX and SEC_POSTFIX. Only the library can judge what is in them.
class Envelope {
public:
    /// Takes the next submessage with its content, and marks it when it is protected.
    [[nodiscard]] Fault take(Submessage& next, Cursor content);
    /// Returns a fault unless all that was opened was closed.
    [[nodiscard]] Fault end() const;

private:
    enum class Place : std::uint8_t { Outside, AfterPrefix, AfterBody };
    [[nodiscard]] Fault takeSecure(const Submessage& next, Cursor content);

    bool m_first = true, m_message = false, m_closed = false;
    Place m_place = Place::Outside;
};

}  // namespace leitstand::screen
