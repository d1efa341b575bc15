#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/base/shared_bytes.h"
#include "core/base/time.h"
#include "core/event/grant_kind.h"

namespace leitstand {

/// Who holds a grant: heartbeats of the holder at 1 Hz, and requests and answers of stations.
struct GrantSample {
    using Kind = GrantKind;
    enum class Action : std::uint8_t {
        Hold,     ///< heartbeat: this station holds it
        Request,  ///< this station requests it from the holder
        Consent,  ///< the holder agrees to give it to @ref other
        Refuse,   ///< the holder keeps it and refuses @ref other
        Release,  ///< this station gives it up
    };
    Time stamp{};         ///< station's clock
    std::string station;  ///< persistent identity of the station
    std::string title;    ///< name of the station for people
    Kind kind = Kind::Drive;
    Action action = Action::Hold;
    std::string robot;  ///< empty for Map
    std::string other;  ///< for Consent and Refuse: station that made the request
    /// Increases whenever the holder changes; of two holders, the one with the higher term is right.
    std::uint64_t term = 0;
};

/// State of the mission's clock, sent at each change.
struct ClockSample {
    Time stamp{};  ///< when @ref elapsed was taken, station's clock
    std::string station;
    bool running = false;
    std::chrono::nanoseconds elapsed{};  ///< mission time at the stamp
    std::chrono::nanoseconds limit{};    ///< length of the mission; 0: not set
};

/// How far a robot's clock is ahead of the station's; sent whenever the estimate has changed.
struct ClockOffsetSample {
    Time stamp{};  ///< station's clock
    std::string robot;
    std::chrono::nanoseconds ahead{};        ///< robot's clock minus station's
    std::chrono::nanoseconds uncertainty{};  ///< standard deviation
    std::chrono::nanoseconds roundTrip{};    ///< round trip of the newest ping
};

/// Undoes an event. If that event is itself an undo, the undone event is in effect again.
struct UndoSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::uint64_t event = 0;  ///< sequence of the event in the mission
    std::string text;         ///< what is undone: a code of undoText()
};

/// The mission's state after an event. Reading the log can start from there.
struct CheckpointSample {
    Time stamp{};                ///< station's clock
    std::uint64_t sequence = 0;  ///< last event that the state includes
    std::uint32_t version = 0;   ///< format of @ref state; readers skip versions that they do not support
    SharedBytes state;           ///< content is private to core/mission
};

/// A note of the operator.
struct NoteSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;  ///< robot that it is about; may be empty
    std::string text;
};

/// A station began or ended recording the mission.
struct SessionSample {
    Time stamp{};         ///< station's clock
    std::string station;  ///< persistent identity of the station
    std::string title;    ///< name of the station for people
    bool start = true;    ///< true: it began; false: it ended
    std::string mission;  ///< name of the mission
    std::string version;  ///< version of Leitstand
    std::uint32_t operators = 1;
};

/// The mission's details for the report, as the operator set them. The newest sample is valid.
struct MissionInfoSample {
    Time stamp{};                  ///< station's clock
    std::string station = {};      ///< persistent identity of the station
    std::string competition = {};  ///< "RoboCup2013"
    std::string team = {}, country = {};
    std::string mission = {};     ///< name, "Preliminary1"
    std::uint32_t operators = 1;  ///< number of people who drive
    std::string area = {};        ///< default area of finds: "yellow", "orange", "red"; may be empty
    std::string profile = {};     ///< scoring profile; empty: the newest profile
};

/// Something that the operator must know: raised, acknowledged, cleared.
struct AlarmSample {
    enum class Severity : std::uint8_t { Information, Warning, Critical };
    enum class State : std::uint8_t { Raised, Acknowledged, Cleared };
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;  ///< robot that it is about; may be empty
    std::string key;    ///< kind of alarm: "link_lost", "disk_full"
    Severity severity = Severity::Warning;
    State state = State::Raised;
    std::string text;  ///< code and figures (logText()); widgets put it into words
};

}  // namespace leitstand
