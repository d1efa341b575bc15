#include "transport/screen/traffic.h"

#include <algorithm>

#include "transport/screen/cursor.h"
#include "transport/screen/datagram.h"

namespace leitstand::screen {
namespace {

constexpr std::size_t HeaderSize = 20;

/// RTPS 2.3, section 9.3.1.2: the two highest bits of an entity's kind.
bool isBuiltin(EntityId id) {
    return (id & 0xc0) == 0xc0;
}

/// Returns the writer that a submessage comes from or goes to; zero when its kind has none.
EntityId writerOf(Kind kind, Cursor body) {
    switch (kind) {
        case Kind::Data:
        case Kind::DataFrag:
            body.take(4);  // flags, where the inline QoS begins
            break;
        case Kind::Heartbeat:
        case Kind::HeartbeatFrag:
        case Kind::Gap:
        case Kind::AckNack:
        case Kind::NackFrag:
            break;
        default:
            return 0;
    }
    body.take(4);  // the reader
    return body.entityId();
}

}  // namespace

Traffic trafficOf(std::span<const std::byte> bytes) {
    Traffic seen = Traffic::Samples;
    Cursor in(bytes, true);
    in.take(HeaderSize);
    while (in.left() > 0) {
        const auto kind = static_cast<Kind>(in.u8());
        in.setLittle((in.u8() & 1) != 0);
        const std::size_t size = in.u16();
        if (isBuiltin(writerOf(kind, in))) return Traffic::Discovery;
        if (kind == Kind::SecBody) seen = Traffic::Encrypted;
        const bool mayBeEmpty = kind == Kind::InfoTimestamp || kind == Kind::Pad;
        if (size == 0 && !mayBeEmpty) break;  // goes to the end
        in.take(size);
        in.skipPadding(size);
    }
    return seen;
}

}  // namespace leitstand::screen
