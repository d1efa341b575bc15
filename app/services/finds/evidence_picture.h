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
    Time at{};  ///< when it was received, station's clock
    /// Highest temperature in a thermal picture [degrees C], whose colours span 15 to 40 degrees; empty for
    /// other pictures.
    std::optional<double> hottest = {};
    Picture picture;  ///< in Rgb8 or Grey8
};

/// Converts the picture @p sample of @p event to one for people. Thermal pictures, which are known from the
/// streams of @p robots, are coloured and get their highest temperature. Error when the picture cannot be
/// decoded or printed.
[[nodiscard]] Result<EvidencePicture> evidencePicture(const PictureSample& sample, const Event& event,
                                                      const std::vector<RobotDescription>& robots);

}  // namespace leitstand
