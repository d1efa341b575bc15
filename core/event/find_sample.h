#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/base/unknown.h"

namespace leitstand {

/// One sign of life of a victim, as the operator judged it.
struct VictimSign {
    enum class State : std::uint8_t { Unknown, Absent, Present };
    State state = State::Unknown;
    std::string text;        ///< "whole body", "waving", "tapping"; may be empty
    double value = Unknown;  ///< for heat [degrees C], for co2 [ppm]
};

/// A sample in the log that shows the victim.
struct VictimEvidence {
    std::string kind;   ///< "picture", "thermal", "gas", "scan", "odometry"
    std::string topic;  ///< ROS name
    /// Sequence of the event in the mission. 0: the event is in another station's log, with this topic and
    /// stamp.
    std::uint64_t sequence = 0;
    Time stamp{};  ///< stamp of the sample
};

/// What was found.
enum class FindKind : std::uint8_t {
    Victim,
    Hazard,  ///< a hazard sign
    Code,    ///< a QR code; its content is the tag
    Object,  ///< another object of interest
};

/// A victim, or another find that the rules ask for, as filed or changed. Each sample has the whole form. Of
/// the samples with the same kind and number, the newest is valid.
struct FindSample {
    using Kind = FindKind;
    enum class Status : std::uint8_t { Hypothesis, Confirmed, Discarded };
    Time stamp{};  ///< when this version was filed, station's clock
    std::string station;
    std::uint32_t number = 0;  ///< 1 for V1; each kind is numbered separately
    Status status = Status::Hypothesis;
    Time found{};             ///< when the evidence was recorded, station's clock
    std::string robot;        ///< robot that found it
    bool autonomous = false;  ///< true: mode A (autonomous) in the report; false: mode T (teleoperated)
    std::uint64_t scan = 0;   ///< key scan with which it moves when poses are corrected; 0: none
    /// Position in that scan's frame [m]; 0 without scan.
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();  ///< position in the map when it was filed [m]
    double deviation = Unknown;                               ///< standard deviation of the position [m]
    VictimSign form, motion, heat, sound, co2;
    std::string situation;  ///< "surface", "trapped", "void", "entombed"; empty: unknown
    std::string tag;        ///< text written on the find
    std::string area;       ///< "yellow", "orange", "red"; empty: unknown
    std::string text;       ///< free text
    std::vector<VictimEvidence> evidence;
    Kind kind = Kind::Victim;
    /// For a discarded find: number of the find of the same kind into which it was merged; 0: none.
    std::uint32_t mergedInto = 0;
};

/// Name of a find for the operator: "V1", "H1" (hazard), "Q1" (QR code), "O1" (object).
[[nodiscard]] std::string nameOf(FindKind kind, std::uint32_t number);

}  // namespace leitstand
