#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/mission/report/map_painter.h"
#include "core/mission/report/report_model.h"
#include "core/mission/score/score.h"
#include "core/mission/score/score_profile.h"
#include "core/perception/picture.h"

namespace leitstand {

/// A picture that shows a find.
struct EvidencePicture {
    std::string caption;  ///< camera, time, what it tells
    Picture picture;      ///< Rgb8 or Grey8
};

/// What a report shows of a find besides its form.
struct FindPages {
    std::vector<EvidencePicture> pictures;
    std::vector<std::string> traces;         ///< other evidence, in words
    MapPicture way;                          ///< the map about it and the way to it; empty without a map
    std::vector<Eigen::Vector2d> wayPixels;  ///< the way in that picture [px]
};

/// A printed report before it is laid out.
struct ReportContent {
    ReportModel model;
    std::string name;                          ///< "RoboCup2013-Team-Mission"
    std::string version;                       ///< of the program that writes it
    Time created{};                            ///< stated in the report
    std::vector<MapPicture> maps;              ///< one for each height, without title
    std::vector<FindPages> finds;              ///< one for each of the model's
    std::vector<std::string> warnings;         ///< what is missing or could not be read
    std::optional<ScoreProfile> profile = {};  ///< rules of the score; empty: there are none
    ScoreResult score;                         ///< by that profile
};

}  // namespace leitstand
