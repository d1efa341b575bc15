#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Settings for finding hazard placards.
struct HazardSettings {
    double smallest = 20.0;        ///< least length of a placard's diagonals [px]
    double lean = 22.0;            ///< largest angle of its diagonals from vertical and horizontal [degrees]
    double stretch = 2.2;          ///< largest ratio of its diagonals, since it may be seen from the side
    double leastConfidence = 0.5;  ///< least confidence of a reported placard
};

/// A hazard placard: a square that stands on a corner.
struct HazardPlacard {
    /// What its colours mean. Transport (classes 1 to 8): "explosive", "flammable", "gas", "wet",
    /// "combustible", "oxidizer", "peroxide", "poison or infectious", "radioactive", "corrosive". "GHS":
    /// white with a red edge, with any pictogram.
    std::string name;
    std::array<Eigen::Vector2d, 4> corners;            ///< top, right, bottom, left [px]
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< middle of the placard [px]
    double size = 0.0;                                 ///< mean of its diagonals [px]
    double confidence = 0.0;                           ///< 0 to 1
};

/// Returns the hazard placards in @p picture, the most certain first; none in pictures without colours. Finds
/// them by their contours (OpenCV) and the colours of their halves (UN Recommendations on the Transport of
/// Dangerous Goods, 5.2.2.2). Pictograms are not read, so placards with the same colours are not
/// distinguished.
[[nodiscard]] std::vector<HazardPlacard> findHazards(const Picture& picture,
                                                     const HazardSettings& settings = {});

}  // namespace leitstand
