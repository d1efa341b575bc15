#pragma once

#include "transport/screen/cursor.h"
#include "transport/screen/datagram.h"

namespace leitstand::screen {

/// Checks the order and sizes of secure submessages in a datagram (DDS-Security 1.1, section 7.3.6). A
/// message that is protected as a whole begins with SRTPS_PREFIX and ends with SRTPS_POSTFIX; only statistics
/// may follow. A submessage that is protected by itself is between SEC_PREFIX and SEC_POSTFIX. Only the
/// library can check the protected content.
class Envelope {
public:
    /// Takes the next submessage and its content. Sets protectedBySignature of @p next.
    [[nodiscard]] Fault take(Submessage& next, Cursor content);
    /// Returns a fault when a prefix has no postfix.
    [[nodiscard]] Fault end() const;

private:
    enum class Place : std::uint8_t { Outside, AfterPrefix, AfterBody };
    [[nodiscard]] Fault takeSecure(const Submessage& next, Cursor content);

    bool m_first = true, m_message = false, m_closed = false;
    Place m_place = Place::Outside;
};

}  // namespace leitstand::screen
