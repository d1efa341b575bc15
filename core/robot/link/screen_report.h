#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace leitstand {

/// Packets of one sender that never reached the DDS library, and why.
struct ScreenDrop {
    enum class Kind : std::uint8_t {
        NoRtps,    ///< broken, cut off or made to break what reads it
        Numbers,   ///< numbers or counts that no writer or reader can have reached
        Impostor,  ///< in the name of a participant at another address
        TooMany,   ///< of participants beyond what a host may have, or with more endpoints
        Flood,     ///< more than a sender that is no participant may send
        Plain,     ///< not encrypted, in a domain with keys
    };
    Kind kind = Kind::NoRtps;
    std::string from;           ///< address; empty: of many senders
    std::uint64_t packets = 0;  ///< so far
    friend bool operator==(const ScreenDrop&, const ScreenDrop&) = default;
};

/// For logs: "somebody sends what is no RTPS: 1,200 packets from 10.0.0.7".
[[nodiscard]] std::string toString(const ScreenDrop& drop);
/// The same in the window's language.
[[nodiscard]] std::string worded(const ScreenDrop& drop);

/// Transports of a profile file that bypass the screen.
enum class Unscreened : std::uint8_t { SharedMemory, Tcp };
/// Why that matters, in the window's language.
[[nodiscard]] std::string worded(Unscreened what);

/// Selects the drops to report to an operator: each when it is first seen, and again at ten times as many.
/// Not thread-safe.
class ScreenMessages {
public:
    /// Returns those of @p drops, all so far, that are due; they then count as reported.
    [[nodiscard]] std::vector<ScreenDrop> due(const std::vector<ScreenDrop>& drops);

private:
    std::map<std::pair<ScreenDrop::Kind, std::string>, std::uint64_t> m_reported;
};

}  // namespace leitstand
