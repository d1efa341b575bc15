#pragma once

#include <chrono>
#include <string>

namespace leitstand {

/// State of one robot's stop as its operator sees it.
struct StopStatus {
    bool supported = true;  ///< the robot obeys stop commands; false: it is held by drive commands of zero
    bool sent = false;      ///< a stop of this station is in force
    bool acknowledged = false;   ///< ... and the robot has acknowledged it
    bool stopped = false;        ///< by any station, as the robot reports
    bool standing = false;       ///< the robot does not move
    bool standingKnown = false;  ///< whether standing is known
    bool releasing = false;      ///< a release is on its way
    std::string stoppedBy;  ///< sender of the command that the robot answered last; empty: its own button
    std::string refused;    ///< why the last release had no effect; until the next command
    std::chrono::nanoseconds unanswered{};  ///< how long the robot has not answered; 0 when it has
    friend bool operator==(const StopStatus&, const StopStatus&) = default;
};

}  // namespace leitstand
