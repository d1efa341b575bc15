#pragma once

#include <string>

#include "core/event/command_samples.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// How the station wants one stream of a robot to be; the robot chooses what is left open.
struct StreamWish {
    bool enabled = true;
    double rate = 0.0;  ///< at most [Hz]; 0: the robot chooses
    int quality = 0;    ///< of JPEG, 1 to 100; 0: the robot chooses
    int maxWidth = 0;   ///< of pictures [px]; 0: the robot chooses

    [[nodiscard]] bool isPlain() const { return *this == StreamWish{}; }
    friend bool operator==(const StreamWish&, const StreamWish&) = default;
};

/// Returns the wish that satisfies both: the slower, coarser, smaller of each; off when one of them is off.
[[nodiscard]] StreamWish stricter(const StreamWish& one, const StreamWish& other);

/// Whether @p stream follows @p wish, as far as the figures show: it is off, or not much faster than
/// requested. They do not show quality and width.
[[nodiscard]] bool isFollowed(const StreamWish& wish, const StreamStatus& stream);

/// Returns @p wish for @p topic as it goes over the wire; stamp and station are left to the sender.
[[nodiscard]] StreamCommandSample commandOf(const std::string& topic, const StreamWish& wish);

}  // namespace leitstand
