#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace leitstand {

/// State of a service that has a part in a robot's stop.
struct StopServiceStatus {
    enum class Stage : std::uint8_t {
        Idle,      ///< no stop of this station is in force
        Asked,     ///< it was asked to stop, but has not confirmed it yet
        Stopped,   ///< it confirmed the stop, or has only a part in the release
        Releasing  ///< it was asked to release, but has not confirmed it yet
    };
    std::string title = {};  ///< name for the operator
    Stage stage = Stage::Idle;
    bool offered = false;  ///< whether anybody offers the service
    bool refused = false;  ///< whether it refused what it was asked last
    /// Its own words, if it refused; or why this station cannot call it. May be empty.
    std::string message = {};
    friend bool operator==(const StopServiceStatus&, const StopServiceStatus&) = default;
};

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
    std::vector<StopServiceStatus> services;  ///< in the order of the robot's file
    std::chrono::nanoseconds unanswered{};    ///< how long the robot has not answered; 0 after an answer
    friend bool operator==(const StopStatus&, const StopStatus&) = default;
};

}  // namespace leitstand
