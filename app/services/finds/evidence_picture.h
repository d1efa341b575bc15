#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/event.h"
#include "core/perception/pictures/picture.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A picture that shows a find.
struct EvidencePicture {
    std::string robot, sensor;
    Time at{};                           ///< station's clock
    std::optional<double> hottest = {};  ///< of a thermal picture, whose colours go from 15 to 40 [degrees C]
    Picture picture;                     ///< Rgb8 or Grey8
};

/// @p event, which @p sample is of, as people look at it: thermal pictures of @p robots in colours, with
/// their hottest place in words.
[[nodiscard]] Result<EvidencePicture> evidencePicture(const PictureSample& sample, const Event& event,
                                                      const std::vector<RobotDescription>& robots);

}  // namespace leitstand
