#include "transport/screen/datagram.h"

#include "transport/screen/cursor.h"
#include "transport/screen/envelope.h"
#include "transport/screen/parameters.h"

namespace leitstand::screen {
namespace {

constexpr std::size_t HeaderSize = 20, StatisticsSize = 56;
constexpr std::uint32_t MostBits = 256;                        // of a set of numbers
constexpr std::uint16_t DataFields = 16, DataFragFields = 28;  // [B] between octetsToInlineQos and the QoS

bool flag(std::uint8_t flags, int bit) {
    return (flags >> bit & 1) != 0;
}

/// Reads the number of bits into @p bits and skips them. False when there are more than RTPS allows.
bool skipBits(Cursor& in, std::uint32_t& bits) {
    bits = in.u32();
    if (bits > MostBits) return false;
    in.take((bits + 31) / 32 * 4);
    return in.ok();
}

Fault readInlineQos(Cursor& in, Submessage& to) {
    return eachParameter(in, to.littleEndian, [&to](const Parameter& parameter) {
        if (parameter.id == pid::KeyHash) to.key = Cursor(parameter.value, false).octets<16>();
        if (parameter.id == pid::StatusInfo) to.ended = (std::to_integer<int>(parameter.value[3]) & 3) != 0;
    });
}

Fault checkFragments(const Submessage& data, std::uint32_t start, std::uint32_t count) {
    if (start == 0 || count == 0) return "DATA_FRAG: no fragment";
    if (data.fragmentSize == 0 || data.sampleSize == 0) return "DATA_FRAG: fragments of nothing";
    const std::uint64_t size = data.fragmentSize, all = (data.sampleSize + size - 1) / size;
    const std::uint64_t end = std::uint64_t(start) - 1 + count;
    if (end > all) return "DATA_FRAG: more fragments than the sample has";
    const std::uint64_t expected = end == all ? data.sampleSize - (start - 1) * size : count * size;
    if (data.payload.size() < expected) return "DATA_FRAG: fewer bytes than its fragments have";
    if (data.payload.size() > expected + 3) return "DATA_FRAG: more bytes than its fragments have";
    return {};
}

Fault readData(Cursor in, std::uint8_t flags, Submessage& to) {
    const bool whole = to.kind == Kind::Data;
    in.u16();
    if (in.u16() != (whole ? DataFields : DataFragFields)) return "DATA: fields of an unknown length";
    to.reader = in.entityId();
    to.writer = in.entityId();
    to.first = to.last = in.sequenceNumber();
    std::uint32_t start = 0, count = 0;
    if (!whole) {
        start = in.u32();
        count = in.u16();
        to.fragmentSize = in.u16();
        to.sampleSize = in.u32();
    }
    if (!in.ok()) return "DATA: is cut off";
    if (to.first < 1) return "DATA: no number of a sample";
    if (flag(flags, 1)) {
        if (const Fault fault = readInlineQos(in, to); !fault.empty()) return fault;
    }
    const bool data = whole && flag(flags, 2);
    to.isKey = flag(flags, whole ? 3 : 2);
    if (data && to.isKey) return "DATA: is both a sample and a key";
    to.payload = in.rest();
    if (!whole) return checkFragments(to, start, count);
    if (data && to.payload.size() < 4) return "DATA: a sample without encapsulation";
    if (to.isKey && to.payload.empty()) return "DATA: an empty key";
    if (!data && !to.isKey && to.payload.size() > 3) return "DATA: bytes that are neither sample nor key";
    return {};
}

Fault readHeartbeat(Cursor in, Submessage& to) {
    to.reader = in.entityId();
    to.writer = in.entityId();
    to.first = in.sequenceNumber();
    to.last = in.sequenceNumber();
    to.count = in.u32();
    if (!in.ok()) return "HEARTBEAT: is cut off";
    if (to.first < 1 || to.last < to.first - 1) return "HEARTBEAT: numbers that are no range";
    return {};
}

Fault readGap(Cursor in, Submessage& to) {
    to.reader = in.entityId();
    to.writer = in.entityId();
    to.first = in.sequenceNumber();
    const std::int64_t base = in.sequenceNumber();
    std::uint32_t bits = 0;
    if (!skipBits(in, bits)) return "GAP: a set of numbers that does not fit";
    if (to.first < 1 || base < to.first) return "GAP: numbers that are no range";
    to.gapped = base - to.first;
    to.last = base > INT64_MAX - MostBits ? INT64_MAX : base - 1 + bits;
    return {};
}

Fault readAckNack(Cursor in, Submessage& to) {
    to.reader = in.entityId();
    to.writer = in.entityId();
    to.first = in.sequenceNumber();
    std::uint32_t bits = 0;
    if (!skipBits(in, bits)) return "ACKNACK: a set of numbers that does not fit";
    to.count = in.u32();
    if (!in.ok()) return "ACKNACK: is cut off";
    if (to.first < 0 || (to.first == 0 && bits > 0)) return "ACKNACK: numbers below one";
    to.last = to.first > INT64_MAX - MostBits ? INT64_MAX : to.first + bits;
    return {};
}

Fault readFragmentWords(Cursor in, Submessage& to) {
    to.reader = in.entityId();
    to.writer = in.entityId();
    to.first = to.last = in.sequenceNumber();
    const std::uint32_t fragment = in.u32();
    std::uint32_t bits = 0;
    if (to.kind == Kind::NackFrag && !skipBits(in, bits)) return "NACK_FRAG: a set that does not fit";
    to.count = in.u32();
    if (!in.ok()) return "HEARTBEAT_FRAG, NACK_FRAG: is cut off";
    if (to.first < 1 || fragment < 1) return "HEARTBEAT_FRAG, NACK_FRAG: numbers below one";
    return {};
}

Fault readReplyLocators(Cursor in, std::uint8_t flags) {
    for (int list = flag(flags, 1) ? 2 : 1; list > 0; --list) {
        const std::uint32_t count = in.u32();
        if (count > in.left() / 24) return "INFO_REPLY: more locators than bytes";
        in.take(count * std::size_t(24));
    }
    return in.ok() ? Fault{} : "INFO_REPLY: is cut off";
}

/// What a submessage sets for those after it: their source and the secure envelope.
struct Context {
    Prefix source{};
    Envelope envelope;
};

Fault readSubmessage(Cursor in, std::uint8_t flags, Context& context, Submessage& to) {
    const std::size_t size = in.left();
    switch (to.kind) {
        case Kind::Data:
        case Kind::DataFrag:
            return readData(in, flags, to);
        case Kind::Heartbeat:
            return readHeartbeat(in, to);
        case Kind::Gap:
            return readGap(in, to);
        case Kind::AckNack:
            return readAckNack(in, to);
        case Kind::NackFrag:
        case Kind::HeartbeatFrag:
            return readFragmentWords(in, to);
        case Kind::InfoTimestamp:
            return flag(flags, 1) || size >= 8 ? Fault{} : "INFO_TS: is cut off";
        case Kind::InfoDestination:
            return size >= 12 ? Fault{} : "INFO_DST: is cut off";
        case Kind::InfoSource:
            if (size < 20) return "INFO_SRC: is cut off";
            in.take(8);
            context.source = in.octets<12>();
            return {};
        case Kind::InfoReply:
            return readReplyLocators(in, flags);
        case Kind::InfoReplyIp4:
            return size >= (flag(flags, 1) ? 16U : 8U) ? Fault{} : "INFO_REPLY_IP4: is cut off";
        default:
            return {};  // the standard: unknown ones are skipped
    }
}

Fault readHeader(Cursor& in, Datagram& to) {
    static constexpr std::array<std::uint8_t, 4> Name = {'R', 'T', 'P', 'S'};
    if (in.octets<4>() != Name) return "no header of RTPS";
    const int major = in.u8();
    in.take(3);  // minor version, vendor
    to.sender = in.octets<12>();
    if (!in.ok()) return "the header is cut off";
    return major == 2 ? Fault{} : "a version other than 2";
}

}  // namespace

Fault parse(std::span<const std::byte> bytes, Datagram& into) {
    into.submessages.clear();
    Cursor in(bytes, true);
    if (const Fault fault = readHeader(in, into); !fault.empty()) return fault;
    Context context;
    context.source = into.sender;
    bool last = in.left() == 0;
    if (last) return "no submessage";
    while (!last) {
        Submessage& next = into.submessages.emplace_back();
        next.kind = static_cast<Kind>(in.u8());
        const std::uint8_t flags = in.u8();
        next.littleEndian = flag(flags, 0);
        in.setLittle(next.littleEndian);
        std::size_t size = in.u16();
        if (!in.ok()) return "the header of a submessage is cut off";
        const bool mayBeEmpty = next.kind == Kind::InfoTimestamp || next.kind == Kind::Pad;
        const bool toTheEnd = size == 0 && !mayBeEmpty;  // the standard: it is the last one
        if (next.kind == Kind::Statistics && (size != StatisticsSize || in.left() != StatisticsSize))
            return "statistics that the library did not append";
        if (toTheEnd) size = in.left();
        if (size > in.left()) return "a submessage longer than the datagram";
        next.source = context.source;
        const Cursor body(in.take(size), next.littleEndian);
        if (const Fault fault = context.envelope.take(next, body); !fault.empty()) return fault;
        if (const Fault fault = readSubmessage(body, flags, context, next); !fault.empty()) return fault;
        in.skipPadding(size);
        last = toTheEnd || in.left() == 0;
    }
    into.speaker = context.source;
    return context.envelope.end();
}

}  // namespace leitstand::screen
