#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/base/unknown.h"
#include "core/event/find_sample.h"

namespace leitstand {

/// One observation that suggests that something is there.
struct Cue {
    std::string kind = {};  ///< "heat", "motion", "co2", "code", "tag", "hazard", "sighting"
    std::string robot = {};
    std::string sensor = {};  ///< StreamDescription::sensor
    std::string topic = {};   ///< ROS name
    std::uint64_t sequence =
        0;         ///< of the sample in the mission; 0: another station's log, found by topic and stamp
    Time stamp{};  ///< sample's own
    double value = Unknown;       ///< heat [degrees C], co2 [ppm]
    double confidence = Unknown;  ///< 0 to 1
    std::string text = {};        ///< content of a code; kind of a hazard; may be empty
};

/// A possible find of the station: cues of one place, joined. The newest sample of an id counts.
struct CandidateSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::uint32_t id = 0;  ///< from 1
    FindSample::Kind kind = FindSample::Kind::Victim;
    std::uint64_t scan = 0;  ///< key scan that it belongs to, whose corrections move it; 0: none
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();  ///< in that scan's frame [m]; without one: 0
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();   ///< when published [m]
    double deviation = Unknown;                                ///< standard deviation of the position [m]
    double confidence = Unknown;                               ///< 0 to 1
    std::uint32_t victim = 0;                                  ///< number that it was filed under; 0: none
    bool dismissed = false;                                    ///< the operator judged it to be none
    std::vector<Cue> cues;                                     ///< the best of each kind
};

}  // namespace leitstand
