#pragma once

#include <string>

#include "core/event/command_samples.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// What the station requests for one stream of a robot. The robot chooses what is left open.
struct StreamRequest {
    bool enabled = true;
    double rate = 0.0;  ///< highest rate [Hz]; 0: the robot chooses
    int quality = 0;    ///< quality of JPEG, 1 to 100; 0: the robot chooses
    int maxWidth = 0;   ///< largest width of a picture [px]; 0: the robot chooses

    [[nodiscard]] bool isPlain() const { return *this == StreamRequest{}; }
    friend bool operator==(const StreamRequest&, const StreamRequest&) = default;
};

/// Returns the request that satisfies both: the lower rate, quality and width; off when one of them is off.
[[nodiscard]] StreamRequest stricter(const StreamRequest& one, const StreamRequest& other);

/// Whether @p stream follows @p request, as far as its figures show: it is off, or not much faster than
/// requested. Quality and width cannot be seen there.
[[nodiscard]] bool isFollowed(const StreamRequest& request, const StreamStatus& stream);

/// Returns @p request for @p topic as a message; the sender fills in stamp and station.
[[nodiscard]] StreamCommandSample commandOf(const std::string& topic, const StreamRequest& request);

}  // namespace leitstand
