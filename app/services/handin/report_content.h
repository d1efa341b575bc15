#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/finds/evidence_picture.h"
#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/handin/map/map_painter.h"
#include "core/handin/report_model.h"
#include "core/mapping/comparison/map_changes.h"
#include "core/mission/score/score.h"
#include "core/mission/score/score_profile.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// CO2 that a robot measured before a find was frozen.
struct GasTrace {
    struct Reading {
        Time at{};         ///< station's clock
        double ppm = 0.0;  ///< parts per million by volume
    };
    std::string robot;
    std::vector<Reading> readings;  ///< by time, at least one; in older missions exactly one
};

/// A scan in the evidence of a find.
struct FrozenScan {
    std::string robot;
    Time at{};                  ///< station's clock
    std::uint64_t keyScan = 0;  ///< id of the key scan that it became; 0: none
    std::size_t points = 0;     ///< number of echoes
    /// The scan from above, with the find in the middle; empty when the place of the find is unknown.
    MapPicture picture;
};

/// Where a robot was when a find was frozen.
struct FrozenPose {
    std::string robot;
    Time at{};                  ///< station's clock
    std::optional<Pose> inMap;  ///< pose of its base; empty: unknown
    Pose inOdom = Pose::Identity();
};

/// What a report shows of a find, in addition to its form.
struct FindPages {
    std::vector<EvidencePicture> pictures;
    int morePictures = 0;  ///< number of further pictures, which are only in the mission
    std::vector<GasTrace> gas;
    std::vector<FrozenScan> scans;
    std::vector<FrozenPose> poses;
    MapPicture way;                          ///< map around the find, with the way to it; empty without a map
    std::vector<Eigen::Vector2d> wayPixels;  ///< the way in that picture [px]
};

/// A map of the report, painted.
struct PrintedMap {
    ReportMap shows;
    MapPicture picture;
};

/// A printed report before it is laid out.
struct ReportContent {
    ReportModel model;
    std::string name;                          ///< "RoboCup2013-Team-Mission"
    std::string version;                       ///< version of the program that writes it
    Time created{};                            ///< time of creation in the report
    std::vector<PrintedMap> maps;              ///< the maps of mapsOf(), without titles
    std::vector<FindPages> finds;              ///< one for each find of the model
    std::vector<std::string> warnings;         ///< what is missing or could not be read
    std::optional<ScoreProfile> profile = {};  ///< rules for the score; empty: there are none
    ScoreResult score;                         ///< score under that profile
    MapChanges changes = {};                   ///< changes between missions, if the map is made from several
};

}  // namespace leitstand
