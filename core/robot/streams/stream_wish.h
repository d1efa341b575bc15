#pragma once

#include <string>

#include "core/event/command_samples.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// How the station wants one stream of a robot to be; what it does not say is as the robot likes.
struct StreamWish {
    bool enabled = true;
    double rate = 0.0;  ///< at most [Hz]; 0: as the robot likes
    int quality = 0;    ///< of JPEG, 1 to 100; 0: as the robot likes
    int maxWidth = 0;   ///< of pictures [px]; 0: as the robot likes

    [[nodiscard]] bool isPlain() const { return *this == StreamWish{}; }
    friend bool operator==(const StreamWish&, const StreamWish&) = default;
};

/// What satisfies both: the slower, coarser, smaller of each; off when one of them is off.
[[nodiscard]] StreamWish stricter(const StreamWish& one, const StreamWish& other);

/// Whether @p stream comes as @p wish asks, as far as that can be seen: it is off, or not much faster than
/// asked for. Quality and width do not show in the figures.
[[nodiscard]] bool isFollowed(const StreamWish& wish, const StreamStatus& stream);

/// @p wish for @p topic as it goes over the wire; stamp and station are left to the sender.
[[nodiscard]] StreamCommandSample commandOf(const std::string& topic, const StreamWish& wish);

}  // namespace leitstand
