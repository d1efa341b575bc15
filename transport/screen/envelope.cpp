#include "transport/screen/envelope.h"

namespace leitstand::screen {
namespace {

constexpr std::size_t CryptoHeader = 20;            // kind, key, session, initialisation vector
constexpr std::size_t CommonMac = 16, OneMac = 20;  // of all receivers; of one, with its key

Fault checkFooter(Cursor content) {
    content.take(CommonMac);
    content.setLittle(false);
    const std::uint32_t macs = content.u32();
    if (!content.ok() || macs > content.left() / OneMac) return "SEC_POSTFIX: more signatures than bytes";
    return content.left() - macs * OneMac < 4 ? Fault{} : "SEC_POSTFIX: bytes that are no signature";
}

Fault checkBody(Cursor content) {
    content.setLittle(false);
    const std::uint32_t size = content.u32();
    return content.ok() && size <= content.left() ? Fault{} : "SEC_BODY: longer than the submessage";
}

}  // namespace

Fault Envelope::takeSecure(const Submessage& next, Cursor content) {
    switch (next.kind) {
        case Kind::SrtpsPrefix:
            if (!m_first) return "SRTPS_PREFIX: is not the first";
            m_message = true;
            return content.left() == CryptoHeader ? Fault{} : "SRTPS_PREFIX: of another size";
        case Kind::SrtpsPostfix:
            if (!m_message || m_place != Place::Outside) return "SRTPS_POSTFIX: closes nothing";
            m_closed = true;
            return checkFooter(content);
        case Kind::SecPrefix:
            if (m_place != Place::Outside) return "SEC_PREFIX: in another one";
            m_place = Place::AfterPrefix;
            return content.left() == CryptoHeader ? Fault{} : "SEC_PREFIX: of another size";
        case Kind::SecPostfix:
            if (m_place != Place::AfterBody) return "SEC_POSTFIX: closes nothing";
            m_place = Place::Outside;
            return checkFooter(content);
        default:
            if (m_place == Place::AfterBody) return "SEC_BODY: is the second";
            if (m_place == Place::Outside && !m_message) return "SEC_BODY: without prefix";
            if (m_place == Place::AfterPrefix) m_place = Place::AfterBody;
            return checkBody(content);
    }
}

Fault Envelope::take(Submessage& next, Cursor content) {
    if (m_closed && next.kind != Kind::Statistics) return "a submessage after SRTPS_POSTFIX";
    const bool secure = next.kind >= Kind::SecBody && next.kind <= Kind::SrtpsPostfix;
    next.protectedBySignature = m_message && !m_closed;
    if (!secure && m_place == Place::AfterBody) return "a second submessage after SEC_PREFIX";
    if (!secure && m_place == Place::AfterPrefix) m_place = Place::AfterBody;
    const Fault fault = secure ? takeSecure(next, content) : Fault{};
    m_first = false;
    return fault;
}

Fault Envelope::end() const {
    if (m_message && !m_closed) return "SRTPS_PREFIX: is never closed";
    return m_place == Place::Outside ? Fault{} : "SEC_PREFIX: is never closed";
}

}  // namespace leitstand::screen
