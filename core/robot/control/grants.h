#pragma once

#include <array>
#include <chrono>
#include <compare>
#include <cstdint>
#include <string>
#include <vector>

#include "core/event/grant_kind.h"

namespace leitstand {

/// A process in the domain. It is identified by where its samples come from, never by their content: by the
/// first 12 bytes of the GUIDs of all its endpoints (RTPS 2.2, section 8.2.4). A restarted program has other
/// bytes.
struct Sender {
    std::array<std::uint8_t, 12> bytes{};
    friend auto operator<=>(const Sender&, const Sender&) = default;
};

/// What can be granted: driving a robot, moving its cameras, or registering the map (then `robot` is empty).
struct GrantId {
    GrantKind kind = GrantKind::Drive;
    std::string robot;
    friend auto operator<=>(const GrantId&, const GrantId&) = default;
};
/// The grant to drive @p robot.
[[nodiscard]] inline GrantId driveGrant(const std::string& robot) {
    return {GrantKind::Drive, robot};
}

/// A grant that a station holds, with its term.
struct HeldGrant {
    GrantId id;
    std::uint64_t term = 0;
    friend bool operator==(const HeldGrant&, const HeldGrant&) = default;
};

/// Identity of a station, which is the same in all its runs.
struct StationIdentity {
    std::string id;               ///< random, made once; never empty
    std::string title;            ///< name for people
    std::vector<HeldGrant> held;  ///< grants held at the end of its last run, which it holds again at once
};

/// Times of the grant protocol (docs/design.md, "The wire"), measured on the receiver's steady clock.
struct GrantTiming {
    std::chrono::nanoseconds heartbeat = std::chrono::seconds(1);
    /// How long the holder must be silent before another station takes over.
    std::chrono::nanoseconds silence = std::chrono::seconds(3);
};

}  // namespace leitstand
