#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/base/unknown.h"
#include "core/event/find_sample.h"

namespace leitstand {

/// One observation that suggests a find.
struct Cue {
    std::string kind = {};  ///< "heat", "motion", "co2", "code", "tag", "hazard", "sighting"
    std::string robot = {};
    std::string sensor = {};  ///< StreamDescription::sensor
    std::string topic = {};   ///< ROS name
    /// Sequence of the sample's event in the mission. 0: the event is in another station's log, with this
    /// topic and stamp.
    std::uint64_t sequence = 0;
    Time stamp{};                 ///< stamp of the sample
    double value = Unknown;       ///< for heat [degrees C], for co2 [ppm]
    double confidence = Unknown;  ///< 0 to 1
    std::string text = {};        ///< content of a code; kind of a hazard; may be empty
};

/// A possible find: cues that the station assigned to one place. The newest sample with an id is the valid
/// one.
struct CandidateSample {
    Time stamp{};  ///< station's clock
    std::string station;
    std::uint32_t id = 0;  ///< number, from 1
    FindSample::Kind kind = FindSample::Kind::Victim;
    std::uint64_t scan = 0;  ///< key scan with which it moves when poses are corrected; 0: none
    /// Position in that scan's frame [m]; 0 without scan.
    Eigen::Vector3d positionInScan = Eigen::Vector3d::Zero();
    /// Position in the map when it was published [m].
    Eigen::Vector3d positionInMap = Eigen::Vector3d::Zero();
    double deviation = Unknown;   ///< standard deviation of the position [m]
    double confidence = Unknown;  ///< 0 to 1
    std::uint32_t victim = 0;     ///< number of the find that it was filed as; 0: none
    bool dismissed = false;       ///< whether the operator decided that it is no find
    std::vector<Cue> cues;        ///< the best cue of each kind
};

}  // namespace leitstand
