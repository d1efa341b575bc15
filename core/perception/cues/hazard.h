#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// What is looked at for hazard placards.
struct HazardSettings {
    double smallest = 20.0;        ///< of a placard's diagonals [px]
    double lean = 22.0;            ///< of its diagonals from upright and level, at most [degrees]
    double stretch = 2.2;          ///< longer diagonal over the shorter, at most (seen from the side)
    double leastConfidence = 0.5;  ///< of what is told
};

/// A hazard placard: a square that stands on a corner.
struct HazardPlacard {
    /// What its colours say: "explosive", "flammable", "gas", "wet", "combustible", "oxidizer", "peroxide",
    /// "poison or infectious", "radioactive", "corrosive" (transport, classes 1 to 8), "GHS" (white with a
    /// red edge; which one, is not told).
    std::string name;
    std::array<Eigen::Vector2d, 4> corners;            ///< top, right, bottom, left [px]
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< [px]
    double size = 0.0;                                 ///< mean of its diagonals [px]
    double confidence = 0.0;                           ///< 0 to 1
};

/// The hazard placards in @p picture (colours; nothing in others), the most certain first. By their contours
/// (OpenCV) and the colours of their halves (UN Recommendations on the Transport of Dangerous
/// Goods, 5.2.2.2): pictograms are not read, so placards of the same colours are not told apart.
[[nodiscard]] std::vector<HazardPlacard> findHazards(const Picture& picture,
                                                     const HazardSettings& settings = {});

}  // namespace leitstand
