#pragma once

#include <chrono>
#include <functional>

#include "transport/screen/cursor.h"
#include "transport/screen/datagram.h"
#include "transport/screen/place.h"

namespace leitstand::screen {

/// Numbers of the parameters that the screen reads itself (RTPS 2.3, tables 9.12 and 9.14).
namespace pid {
constexpr std::uint16_t Sentinel = 0x0001, LeaseDuration = 0x0002, KeyHash = 0x0070, StatusInfo = 0x0071,
                        UnicastLocator = 0x0031, MetatrafficUnicastLocator = 0x0032,
                        MetatrafficMulticastLocator = 0x0033, MulticastLocator = 0x0048,
                        ParticipantGuid = 0x0050, EndpointGuid = 0x005a;
}  // namespace pid

struct Parameter {
    std::uint16_t id = 0;
    std::span<const std::byte> value;
    bool littleEndian = false;
};

/// Checks that @p parameter is as long as its kind requires, and that all counts, texts and sequences in it
/// fit.
[[nodiscard]] Fault checkParameter(const Parameter& parameter);

/// Checks each parameter of a list and calls @p take with it. The list must have an end. Stops at the first
/// fault.
template <class Take>
[[nodiscard]] Fault eachParameter(Cursor& in, bool littleEndian, Take take) {
    for (;;) {
        Parameter parameter;
        parameter.littleEndian = littleEndian;
        parameter.id = in.u16();
        const std::size_t size = in.u16();
        if (!in.ok()) return "a parameter list without end";
        if (parameter.id == pid::Sentinel) return {};
        if (size % 4 != 0) return "a parameter that is no multiple of four bytes";
        parameter.value = in.take(size);
        if (!in.ok()) return "a parameter longer than its list";
        if (const Fault fault = checkParameter(parameter); !fault.empty()) return fault;
        take(parameter);
    }
}

using Seconds = std::chrono::duration<double>;

/// What a participant announces about itself, as far as the screen uses it.
struct Announcement {
    Prefix participant{};
    bool ends = false;               ///< whether the participant leaves
    Seconds lease{100.0};            ///< default is that of the standard
    std::vector<Address> addresses;  ///< addresses that it claims to have, at most sixteen
    std::vector<std::uint16_t> discoveryPorts,
        samplePorts;  ///< ports on which it receives discovery and samples, at most sixteen each
};
/// What a participant announces about a writer or reader.
struct EndpointAnnouncement {
    GuidBytes endpoint{};
    bool ends = false;
};

/// Reads what @p data announces or ends: a participant, or (second form) a writer or reader. Faults are those
/// of checkParameter(), an unknown encapsulation, or that no participant or endpoint is named.
[[nodiscard]] Fault read(const Submessage& data, Announcement& into);
[[nodiscard]] Fault read(const Submessage& data, EndpointAnnouncement& into);

/// Checks a sample from the writer with which participants prove their identity (DDS-Security 1.1, section
/// 7.4.3).
[[nodiscard]] Fault checkAuthentication(std::span<const std::byte> sample);
/// Checks a sample from the writer with which participants assert liveliness. Sets @p participant to the
/// participant in the sample.
[[nodiscard]] Fault checkLiveliness(std::span<const std::byte> sample, Prefix& participant);

}  // namespace leitstand::screen
