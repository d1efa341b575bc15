#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/base/shared_bytes.h"
#include "core/base/time.h"
#include "core/event/grant_kind.h"

namespace leitstand {

/// Who holds a grant: heartbeat of the holder at 1 Hz, and the requests and answers of stations about it.
struct GrantSample {
    using Kind = GrantKind;
    enum class Action : std::uint8_t {
        Hold,     ///< heartbeat: the station has it
        Request,  ///< the station requests it from the holder
        Consent,  ///< the holder gives it to @ref other
        Refuse,   ///< the holder keeps it and refuses @ref other
        Release,  ///< the station gives it up
    };
    Time stamp{};         ///< station's clock
    std::string station;  ///< persistent identity
    std::string title;    ///< of the station, for people
    Kind kind = Kind::Drive;
    Action action = Action::Hold;
    std::string robot;       ///< empty for Map
    std::string other;       ///< station that Consent and Refuse are for
    std::uint64_t term = 0;  ///< rises whenever the holder changes: of two holders, the higher term is right
};

/// State of the mission's clock, sent on change.
struct ClockSample {
    Time stamp{};  ///< station's clock when @ref elapsed was taken
    std::string station;
    bool running = false;
    std::chrono::nanoseconds elapsed{};  ///< mission time at the stamp
    std::chrono::nanoseconds limit{};    ///< length of the mission; 0: none
};

/// How far a robot's clock is ahead of the station's; sent whenever the estimate changed.
struct ClockOffsetSample {
    Time stamp{};  ///< station's clock
    std::string robot;
    std::chrono::nanoseconds ahead{};        ///< robot's clock minus station's
    std::chrono::nanoseconds uncertainty{};  ///< standard deviation
    std::chrono::nanoseconds roundTrip{};    ///< of the newest ping
};

/// Takes back an event. When that event is an undo, what it took back counts again.
struct UndoSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::uint64_t event = 0;  ///< sequence of the event in the mission
    std::string text;         ///< what is undone, for people
};

/// The mission's state after an event, so that reading the log can continue from there.
struct CheckpointSample {
    Time stamp{};                ///< station's clock
    std::uint64_t sequence = 0;  ///< last event that the state includes
    std::uint32_t version = 0;   ///< format of @ref state; readers skip versions that they do not know
    SharedBytes state;           ///< meaning is private to core/mission
};

/// A note of the operator.
struct NoteSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;  ///< robot that it is about; may be empty
    std::string text;
};

/// A station began or stopped writing the mission.
struct SessionSample {
    Time stamp{};         ///< station's clock
    std::string station;  ///< persistent identity
    std::string title;    ///< of the station, for people
    bool start = true;    ///< false: end
    std::string mission;  ///< name
    std::string version;  ///< of Leitstand
    std::uint32_t operators = 1;
};

/// The report's details of the mission, as the operator set them; the newest counts.
struct MissionInfoSample {
    Time stamp{};                  ///< station's clock
    std::string station = {};      ///< persistent identity
    std::string competition = {};  ///< "RoboCup2013"
    std::string team = {}, country = {};
    std::string mission = {};     ///< name, "Preliminary1"
    std::uint32_t operators = 1;  ///< people who drive
    std::string area = {};        ///< default of a find's area: "yellow", "orange", "red"; may be empty
    std::string profile = {};     ///< scoring profile; empty: the newest profile
};

/// Something that the operator must know: raised, acknowledged, cleared.
struct AlarmSample {
    enum class Severity : std::uint8_t { Information, Warning, Critical };
    enum class State : std::uint8_t { Raised, Acknowledged, Cleared };
    Time stamp{};  ///< station's clock
    std::string station;
    std::string robot;  ///< may be empty
    std::string key;    ///< what alarms of one kind have in common: "link_lost", "disk_full"
    Severity severity = Severity::Warning;
    State state = State::Raised;
    std::string text;  ///< code and figures (logText()); widgets have the words
};

}  // namespace leitstand
