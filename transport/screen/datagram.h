#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace leitstand::screen {

using Prefix = std::array<std::uint8_t, 12>;     ///< participant's part of a GUID
using GuidBytes = std::array<std::uint8_t, 16>;  ///< prefix and entity
using EntityId = std::uint32_t;  ///< in the order of its bytes: 0x000100c2 announces participants

/// What is wrong with a datagram, in words for developers; empty: nothing.
using Fault = std::string_view;

/// Entities that every participant has (RTPS 2.3, table 9.3; DDS-Security 1.1, table 8).
namespace entity {
constexpr EntityId ParticipantWriter = 0x000100c2, PublicationsWriter = 0x000003c2,
                   SubscriptionsWriter = 0x000004c2, LivelinessWriter = 0x000200c2,
                   AuthenticationWriter = 0x000201c3, AuthenticationReader = 0x000201c4;
}  // namespace entity

/// Kinds of submessages, with their numbers in datagrams (RTPS 2.3, section 9.4.5.1.1; DDS-Security 1.1,
/// section 7.3.6).
enum class Kind : std::uint8_t {
    Pad = 0x01,
    AckNack = 0x06,
    Heartbeat = 0x07,
    Gap = 0x08,
    InfoTimestamp = 0x09,
    InfoSource = 0x0c,
    InfoReplyIp4 = 0x0d,
    InfoDestination = 0x0e,
    InfoReply = 0x0f,
    NackFrag = 0x12,
    HeartbeatFrag = 0x13,
    Data = 0x15,
    DataFrag = 0x16,
    SecBody = 0x30,
    SecPrefix = 0x31,
    SecPostfix = 0x32,
    SrtpsPrefix = 0x33,
    SrtpsPostfix = 0x34,
    Statistics = 0x80,  ///< appended by Fast DDS to everything that it sends, if it was built with statistics
};

/// A submessage and its fields, which are not verified. Fields that its kind does not have are zero.
struct Submessage {
    Kind kind = Kind::Pad;
    bool protectedBySignature = false;  ///< whether it is between SRTPS_PREFIX and SRTPS_POSTFIX
    Prefix source{};                    ///< participant that it claims to come from
    EntityId reader = 0, writer = 0;
    std::int64_t first = 0;  ///< number of the sample; first number of a HEARTBEAT or GAP; base of an ACKNACK
    /// Last number of a HEARTBEAT, GAP or ACKNACK, including its bits; otherwise same as `first`.
    std::int64_t last = 0;
    std::int64_t gapped = 0;         ///< how many numbers a GAP has before its bits
    std::uint32_t count = 0;         ///< count of a HEARTBEAT, ACKNACK, HEARTBEAT_FRAG or NACK_FRAG
    std::uint32_t sampleSize = 0;    ///< size of the whole sample of a DATA_FRAG [B]
    std::uint16_t fragmentSize = 0;  ///< [B]
    bool littleEndian = false;
    bool isKey = false;                  ///< whether the payload is only a key, so that the instance ends
    bool ended = false;                  ///< whether the instance is disposed or unregistered (inline QoS)
    std::optional<GuidBytes> key;        ///< key of the instance, from the inline QoS
    std::span<const std::byte> payload;  ///< payload of DATA and DATA_FRAG, as a view of the datagram
};

/// A parsed datagram. When reused, it allocates no new memory.
struct Datagram {
    Prefix sender{};  ///< participant in the header
    /// Participant in the last INFO_SRC, otherwise in the header: the library considers it alive.
    Prefix speaker{};
    std::vector<Submessage> submessages;
};

/// Parses @p bytes and checks everything that can be judged without earlier datagrams. These are the header,
/// each submessage's kind, length and fields, inline QoS, fragments against their sample, and secure
/// envelopes. A submessage with statistics must be the last one, with the length that the library writes.
/// Never reads outside of @p bytes, whatever they contain. After a fault, @p into is undefined.
[[nodiscard]] Fault parse(std::span<const std::byte> bytes, Datagram& into);

}  // namespace leitstand::screen
