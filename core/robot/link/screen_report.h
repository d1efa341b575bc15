#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace leitstand {

/// Packets of one sender that were not passed to the DDS library, and why.
struct ScreenDrop {
    enum class Kind : std::uint8_t {
        NoRtps,    ///< not RTPS: damaged, truncated, or made to crash its reader
        Numbers,   ///< with numbers or counts that no writer or reader can have reached
        Impostor,  ///< from a sender that claims to be a participant with another address
        /// With more participants than a host may have, or more endpoints than a participant may have.
        TooMany,
        Flood,  ///< more packets than are accepted from a sender that is no participant
        Plain,  ///< not encrypted, in a domain with keys
    };
    Kind kind = Kind::NoRtps;
    std::string from;           ///< address of the sender; empty: many senders
    std::uint64_t packets = 0;  ///< number of packets so far
    friend bool operator==(const ScreenDrop&, const ScreenDrop&) = default;
};

/// Text for logs: "somebody sends what is no RTPS: 1,200 packets from 10.0.0.7".
[[nodiscard]] std::string toString(const ScreenDrop& drop);
/// The same text in the window's language.
[[nodiscard]] std::string worded(const ScreenDrop& drop);

/// Transports in a profile file that bypass the screen.
enum class Unscreened : std::uint8_t { SharedMemory, Tcp };
/// Returns why a transport that bypasses the screen is a risk, in the window's language.
[[nodiscard]] std::string worded(Unscreened what);

/// Selects the drops to report to an operator: each when it is first seen, and again when it has ten times as
/// many packets. Not thread-safe.
class ScreenMessages {
public:
    /// Returns those of @p drops that should be reported now, and marks them as reported. @p drops: all so
    /// far.
    [[nodiscard]] std::vector<ScreenDrop> due(const std::vector<ScreenDrop>& drops);

private:
    std::map<std::pair<ScreenDrop::Kind, std::string>, std::uint64_t> m_reported;
};

}  // namespace leitstand
