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
    double value = Unknown;  ///< heat [degrees C], co2 [ppm]
};

/// A sample in the log that shows the victim.
struct VictimEvidence {
    std::string kind;   ///< "picture", "thermal", "gas", "scan", "odometry"
    std::string topic;  ///< ROS name
    /// Sequence of the event in the mission. 0: the event is in another station's log, under this topic and
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

/// A victim or another find that judges ask for, as filed or changed. Each sample holds the whole form; of
/// samples with the same kind and number, the newest counts.
struct FindSample {
    using Kind = FindKind;
    enum class Status : std::uint8_t { Hypothesis, Confirmed, Discarded };
    Time stamp{};  ///< station's clock, when this version was filed
    std::string station;
    std::uint32_t number = 0;  ///< V1 is 1; each kind has its own numbers
    Status status = Status::Hypothesis;
    Time found{};             ///< station's clock, when the evidence was frozen
    std::string robot;        ///< robot that found it
    bool autonomous = false;  ///< true: mode A of the report; false: mode T (teleoperated)
    std::uint64_t scan = 0;   ///< key scan that it moves with when poses are corrected; 0: none
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();  ///< in that scan's frame [m]; 0 without scan
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();   ///< when filed [m]
    double deviation = Unknown;                                ///< standard deviation of the position [m]
    VictimSign form, motion, heat, sound, co2;
    std::string situation;  ///< "surface", "trapped", "void", "entombed"; empty: unknown
    std::string tag;        ///< text written on the find
    std::string area;       ///< "yellow", "orange", "red"; empty: unknown
    std::string text;       ///< free text
    std::vector<VictimEvidence> evidence;
    Kind kind = Kind::Victim;
    /// If discarded: number of the find of the same kind that it was merged into; 0: none.
    std::uint32_t mergedInto = 0;
};

/// Name of a find for the operator: "V1", "H1" (hazard), "Q1" (QR code), "O1" (object).
[[nodiscard]] std::string nameOf(FindKind kind, std::uint32_t number);

}  // namespace leitstand
