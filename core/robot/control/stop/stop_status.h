#pragma once

#include <chrono>
#include <string>

namespace leitstand {

/// State of one robot's stop as its operator sees it.
struct StopStatus {
    bool supported = true;       ///< the robot obeys stop commands; else only its drive commands become zero
    bool sent = false;           ///< a stop of this station is in force
    bool acknowledged = false;   ///< ... and the robot has taken it
    bool stopped = false;        ///< by any station, as the robot reports
    bool standing = false;       ///< it does not move
    bool standingKnown = false;  ///< whether anything reports it
    bool releasing = false;      ///< a release is on its way
    std::string stoppedBy;  ///< identity of the station that the robot answered last; empty: its own button
    std::string refused;    ///< why the last release had no effect; until the next command
    std::chrono::nanoseconds unanswered{};  ///< how long the robot has not answered; 0 when it has
    friend bool operator==(const StopStatus&, const StopStatus&) = default;
};

}  // namespace leitstand
