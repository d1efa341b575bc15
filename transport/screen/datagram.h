#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace leitstand::screen {

using Prefix = std::array<std::uint8_t, 12>;     ///< of the GUIDs of a participant
using GuidBytes = std::array<std::uint8_t, 16>;  ///< prefix and entity
using EntityId = std::uint32_t;                  ///< as in its bytes: 0x000100c2 announces participants

/// What is wrong, in words for developers; empty: nothing.
using Fault = std::string_view;

/// Entities that every participant has (RTPS 2.3, table 9.3; DDS-Security 1.1, table 8).
namespace entity {
constexpr EntityId ParticipantWriter = 0x000100c2, PublicationsWriter = 0x000003c2,
                   SubscriptionsWriter = 0x000004c2, LivelinessWriter = 0x000200c2,
                   AuthenticationWriter = 0x000201c3, AuthenticationReader = 0x000201c4;
}  // namespace entity

/// Submessages by their number on the wire (RTPS 2.3, section 9.4.5.1.1; DDS-Security 1.1, section 7.3.6).
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
    Statistics = 0x80,  ///< appended by Fast DDS to all that it sends, where it was built with statistics
};

/// A submessage with what it claims. Fields that its kind lacks are zero.
struct Submessage {
    Kind kind = Kind::Pad;
    bool protectedBySignature = false;  ///< stands between SRTPS_PREFIX and SRTPS_POSTFIX
    Prefix source{};                    ///< the participant that it claims to come from
    EntityId reader = 0, writer = 0;
    std::int64_t first = 0;        ///< number of the sample; first of a HEARTBEAT or GAP, base of an ACKNACK
    std::int64_t last = 0;         ///< last of a HEARTBEAT, GAP or ACKNACK, bits included; else as `first`
    std::int64_t gapped = 0;       ///< how many numbers a GAP covers before its bits
    std::uint32_t count = 0;       ///< of HEARTBEAT, ACKNACK, HEARTBEAT_FRAG, NACK_FRAG
    std::uint32_t sampleSize = 0;  ///< of a DATA_FRAG's whole sample [B]
    std::uint16_t fragmentSize = 0;  ///< [B]
    bool littleEndian = false;
    bool isKey = false;                  ///< the payload is only a key: the instance ends
    bool ended = false;                  ///< the instance is disposed or unregistered (inline QoS)
    std::optional<GuidBytes> key;        ///< of the instance, by the inline QoS
    std::span<const std::byte> payload;  ///< of DATA and DATA_FRAG; a view of the datagram
};

/// A parsed datagram. When reused, it allocates no new memory.
struct Datagram {
    Prefix sender{};   ///< of the header
    Prefix speaker{};  ///< of the last INFO_SRC, else of the header: the library considers this participant
                       ///< alive
    std::vector<Submessage> submessages;
};

/// Parses @p bytes and checks all that can be judged without knowing what came before. Checks the header,
/// each submessage's kind, length and fields, inline QoS, fragments against their sample, and secure
/// envelopes. The submessage of statistics must be the last and as long as the library writes it. Never reads
/// outside of @p bytes, whatever they contain; @p into is undefined after a fault.
[[nodiscard]] Fault parse(std::span<const std::byte> bytes, Datagram& into);

}  // namespace leitstand::screen
