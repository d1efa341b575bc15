#include "transport/screen/parameters.h"

#include <algorithm>

namespace leitstand::screen {
namespace {

constexpr std::uint32_t LongestText = 1024, LongestUserData = 16'384;
constexpr std::size_t MostLocators = 16;

/// Returns the least length of values of a fixed size. Other parameters have content of their own, or none
/// that the library reads.
std::size_t leastSize(std::uint16_t id) {
    switch (id) {
        case 0x0006:  // ownership strength
        case 0x000f:  // domain
        case 0x0015:  // version
        case 0x0016:  // vendor
        case 0x001d:  // durability
        case 0x001f:  // ownership
        case 0x0025:  // destination order
        case 0x0043:  // expects inline QoS
        case 0x0049:  // transport priority
        case 0x0053:  // entity of the group
        case 0x0058:  // builtin endpoints
        case 0x0060:  // greatest size of the type
        case pid::StatusInfo:
            return 4;
        case pid::LeaseDuration:
        case 0x0004:  // time based filter
        case 0x0021:  // presentation
        case 0x0023:  // deadline
        case 0x0027:  // latency budget
        case 0x002b:  // lifespan
        case 0x0040:  // history
        case 0x1004:  // security of the endpoint
        case 0x1005:  // security of the participant
            return 8;
        case 0x001a:  // reliability
        case 0x001b:  // liveliness
        case 0x0041:  // resource limits
            return 12;
        case pid::ParticipantGuid:
        case pid::EndpointGuid:
        case 0x0052:  // guid of the group
        case pid::KeyHash:
            return 16;
        case 0x002f:  // locators of all kinds
        case 0x0030:
        case pid::UnicastLocator:
        case pid::MetatrafficUnicastLocator:
        case pid::MetatrafficMulticastLocator:
        case pid::MulticastLocator:
            return 24;
        case 0x001e:  // durability service
            return 28;
        default:
            return 0;
    }
}

bool skipText(Cursor& in, std::uint32_t longest = LongestText) {
    const std::uint32_t size = in.u32();
    if (size > longest || size > in.left()) return false;
    const auto text = in.take(size);
    in.skipPadding(size);
    // The library copies up to the terminating zero.
    return in.ok() && (size == 0 || text.back() == std::byte{0});
}

/// Skips bytes and the count before them.
bool skipBytes(Cursor& in) {
    const std::uint32_t size = in.u32();
    if (size > in.left()) return false;
    in.take(size);
    in.skipPadding(size);
    return in.ok();
}

/// Skips a count and as many elements, of at least @p least bytes each.
template <class Skip>
bool skipSequence(Cursor& in, std::size_t least, Skip skip) {
    const std::uint32_t count = in.u32();
    if (!in.ok() || count > in.left() / least) return false;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!skip(in)) return false;
    }
    return true;
}

bool skipProperty(Cursor& in) {
    return skipText(in, LongestUserData) && skipText(in, LongestUserData);
}
bool skipBinaryProperty(Cursor& in) {
    return skipText(in) && skipBytes(in);
}
/// Skips a token: name, properties, binary properties.
bool skipDataHolder(Cursor& in) {
    return skipText(in) && skipSequence(in, 8, skipProperty) && skipSequence(in, 8, skipBinaryProperty);
}
bool skipTwoBytes(Cursor& in) {
    in.take(2);
    return in.ok();
}
bool skipEightBytes(Cursor& in) {
    in.take(8);
    return in.ok();
}
bool skipOneText(Cursor& in) {
    return skipText(in);
}

bool fits(std::uint16_t id, Cursor in) {
    switch (id) {
        case 0x0005:  // topic
        case 0x0007:  // type
        case 0x0062:  // name of the entity
        case 0x4014:  // domain tag
            return skipText(in);
        case 0x0029:  // partitions
            return skipSequence(in, 4, skipOneText);
        case 0x0035:  // content filter: name, topic, class, expression, its values
            return skipText(in) && skipText(in) && skipText(in) && skipText(in, LongestUserData) &&
                   skipSequence(in, 4, skipOneText);
        case 0x002c:  // user data
        case 0x002d:  // group data
        case 0x002e:  // topic data
            return in.left() <= LongestUserData && skipBytes(in);
        case 0x0059:  // properties
            return skipSequence(in, 8, skipProperty);
        case 0x0073:  // representations
            return skipSequence(in, 2, skipTwoBytes);
        case 0x1001:  // identity
        case 0x1002:  // permissions
        case 0x1006:  // status of the identity
            return skipDataHolder(in);
        case 0x1003:  // tags
            return skipSequence(in, 8, skipProperty);
        case 0x8006:  // domains of shared data, by Fast DDS
            return in.left() % 8 != 4 || skipSequence(in, 8, skipEightBytes);
        default:
            return in.left() >= leastSize(id);
    }
}

/// Sets @p in behind the encapsulation of @p sample. False when that is neither @p big nor the next number.
bool skipEncapsulation(std::span<const std::byte> sample, std::uint16_t big, bool& little, Cursor& in) {
    in = Cursor(sample, false);
    const std::uint16_t kind = in.u16();
    in.take(2);
    little = kind == big + 1;
    in.setLittle(little);
    return in.ok() && (little || kind == big);
}

/// Calls @p take with each parameter of the sample or key in @p data.
template <class Take>
Fault eachOf(const Submessage& data, Take take) {
    constexpr std::uint16_t ParametersBigEndian = 0x0002;
    Cursor in({}, false);
    bool little = false;
    if (!skipEncapsulation(data.payload, ParametersBigEndian, little, in)) return "an unknown encapsulation";
    return eachParameter(in, little, take);
}

Seconds durationOf(const Parameter& parameter) {
    Cursor in(parameter.value, parameter.littleEndian);
    const auto whole = static_cast<std::int32_t>(in.u32());
    return whole < 0 ? Seconds{0.0} : Seconds{double(whole) + double(in.u32()) / 4294967296.0};
}

template <class Value>
void noteOnce(const Value& value, std::vector<Value>& into) {
    const bool known = std::find(into.begin(), into.end(), value) != into.end();
    if (!known && into.size() < MostLocators) into.push_back(value);
}

void noteLocator(const Parameter& parameter, Announcement& into) {
    Cursor in(parameter.value, parameter.littleEndian);
    in.take(4);  // kind
    const auto port = static_cast<std::uint16_t>(in.u32());
    const bool samples = parameter.id == pid::UnicastLocator || parameter.id == pid::MulticastLocator;
    noteOnce(port, samples ? into.samplePorts : into.discoveryPorts);
    const bool unicast =
        parameter.id == pid::UnicastLocator || parameter.id == pid::MetatrafficUnicastLocator;
    if (unicast) noteOnce(in.octets<16>(), into.addresses);
}

void note(const Parameter& parameter, Announcement& into, bool& named) {
    Cursor in(parameter.value, parameter.littleEndian);
    switch (parameter.id) {
        case pid::KeyHash:
        case pid::ParticipantGuid:
            into.participant = in.octets<12>();
            named = true;
            break;
        case pid::LeaseDuration:
            into.lease = durationOf(parameter);
            break;
        case pid::UnicastLocator:
        case pid::MetatrafficUnicastLocator:
        case pid::MulticastLocator:
        case pid::MetatrafficMulticastLocator:
            noteLocator(parameter, into);
            break;
        default:
            break;
    }
}

}  // namespace

Fault checkParameter(const Parameter& parameter) {
    const Cursor in(parameter.value, parameter.littleEndian);
    return fits(parameter.id, in) ? Fault{} : "a parameter that does not hold what it says";
}

Fault read(const Submessage& data, Announcement& into) {
    into = {};
    into.ends = data.ended || data.isKey;
    bool named = data.key.has_value();
    if (named) std::copy_n(data.key->begin(), 12, into.participant.begin());
    if (data.payload.empty()) return named ? Fault{} : "nobody is announced";
    if (const Fault fault = eachOf(data, [&](const Parameter& one) { note(one, into, named); });
        !fault.empty())
        return fault;
    return named ? Fault{} : "nobody is announced";
}

Fault read(const Submessage& data, EndpointAnnouncement& into) {
    into = {};
    into.ends = data.ended || data.isKey;
    bool named = data.key.has_value();
    if (named) into.endpoint = *data.key;
    if (data.payload.empty()) return named ? Fault{} : "no endpoint is announced";
    const Fault fault = eachOf(data, [&](const Parameter& one) {
        if (one.id != pid::EndpointGuid && one.id != pid::KeyHash) return;
        into.endpoint = Cursor(one.value, one.littleEndian).octets<16>();
        named = true;
    });
    if (!fault.empty()) return fault;
    return named ? Fault{} : "no endpoint is announced";
}

Fault checkAuthentication(std::span<const std::byte> sample) {
    constexpr std::uint16_t PlainBigEndian = 0x0000;
    constexpr std::size_t Identities = 2 * (16 + 8), Guids = 3 * 16;
    Cursor in({}, false);
    bool little = false;
    if (!skipEncapsulation(sample, PlainBigEndian, little, in)) return "an unknown encapsulation";
    in.take(Identities + Guids);
    if (!skipText(in) || !skipSequence(in, 12, skipDataHolder)) return "authentication: does not fit";
    return {};
}

Fault checkLiveliness(std::span<const std::byte> sample, Prefix& participant) {
    constexpr std::uint16_t PlainBigEndian = 0x0000;
    Cursor in({}, false);
    bool little = false;
    if (!skipEncapsulation(sample, PlainBigEndian, little, in)) return "an unknown encapsulation";
    participant = in.octets<12>();
    in.take(4);  // what kind of liveliness
    return skipBytes(in) ? Fault{} : "liveliness: does not fit";
}

}  // namespace leitstand::screen
