#pragma once

#include <chrono>
#include <string>

namespace leitstand {

/// State of one robot's stop, as its operator sees it.
struct StopStatus {
    bool supported = true;  ///< whether the robot obeys stop commands; if not, drive commands of zero hold it
    bool locks = false;     ///< whether a lock of its drive commands is set, too (StreamRole::StopLock)
    bool lockHeard = false;      ///< whether anybody listens to that lock
    bool sent = false;           ///< whether a stop of this station is in force ...
    bool acknowledged = false;   ///< ... and the robot has acknowledged it
    bool stopped = false;        ///< whether any station stopped it, as the robot reports
    bool standing = false;       ///< the robot does not move
    bool standingKnown = false;  ///< whether standing is known
    bool releasing = false;      ///< whether a release was sent and is not answered yet
    /// Sender of the command that the robot answered last; empty: its own stop button.
    std::string stoppedBy;
    std::string refused;  ///< why the last release had no effect; kept until the next command
    std::chrono::nanoseconds unanswered{};  ///< how long the robot has not answered; 0 after an answer
    friend bool operator==(const StopStatus&, const StopStatus&) = default;
};

}  // namespace leitstand
