#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// Packets of one sender that never reached the DDS library, and why.
struct ScreenDrop {
    enum class Kind : std::uint8_t {
        NoRtps,    ///< broken, cut off or made to break what reads it
        Numbers,   ///< numbers or counts that no writer or reader can have reached
        Impostor,  ///< in the name of a participant that speaks from elsewhere
        TooMany,   ///< of participants beyond what a host may have, or with more endpoints
        Flood,     ///< more than one may send who is no participant
        Plain,     ///< not encrypted, in a domain with keys
    };
    Kind kind = Kind::NoRtps;
    std::string from;           ///< address; empty: of many
    std::uint64_t packets = 0;  ///< so far
    friend bool operator==(const ScreenDrop&, const ScreenDrop&) = default;
};

/// For logs: "somebody sends what is no RTPS: 1,200 packets from 10.0.0.7".
[[nodiscard]] std::string toString(const ScreenDrop& drop);
/// Likewise, in the window's language.
[[nodiscard]] std::string worded(const ScreenDrop& drop);

}  // namespace leitstand
