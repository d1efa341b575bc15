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
    Time at{};  ///< station's clock
    /// Hottest temperature in a thermal picture [degrees C], whose colours go from 15 to 40; empty for
    /// others.
    std::optional<double> hottest = {};
    Picture picture;  ///< Rgb8 or Grey8
};

/// Converts the picture @p sample of @p event into one for people. Thermal pictures, known by the streams of
/// @p robots, become coloured, with their hottest temperature. Error when the picture cannot be decoded or
/// printed.
[[nodiscard]] Result<EvidencePicture> evidencePicture(const PictureSample& sample, const Event& event,
                                                      const std::vector<RobotDescription>& robots);

}  // namespace leitstand
