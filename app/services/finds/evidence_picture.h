#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/perception/pictures/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct PictureSample;
struct Event;

/// A picture that shows a find.
struct EvidencePicture {
    std::string robot, sensor;
    Time at{};                           ///< station's clock
    std::optional<double> hottest = {};  ///< of a thermal picture, whose colours go from 15 to 40 [degrees C]
    Picture picture;                     ///< Rgb8 or Grey8
};

/// Converts @p event, whose sample is @p sample, for people to look at. Thermal pictures of @p robots become
/// coloured, with their hottest temperature. Error when it cannot be decoded or printed.
[[nodiscard]] Result<EvidencePicture> evidencePicture(const PictureSample& sample, const Event& event,
                                                      const std::vector<RobotDescription>& robots);

}  // namespace leitstand
