#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Settings of the detection of motion.
struct MotionSettings {
    double background = 2.0;   ///< time constant of the still background [s]
    double activity = 0.8;     ///< time constant of how often a place moved [s]
    double longestGap = 1.5;   ///< longest gap between pictures [s]; after a longer one all begins again
    double warmUp = 1.0;       ///< time before motion is reported [s]
    double contrast = 14.0;    ///< least change of brightness, of 255 ...
    double noise = 8.0;        ///< ... and in standard deviations of the picture's own noise
    double often = 0.3;        ///< a place must move in this share of the last pictures
    double smallest = 0.0004;  ///< things below this share of the picture are noise
    double largest = 0.2;      ///< if more of the picture moves, the light changed or the camera moved
};

/// Something that moves before a camera at rest.
struct MotionBlob {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the motion; first pixel's middle: 0.5 [px]
    int left = 0, top = 0, right = 0, bottom = 0;      ///< box [px]; right and bottom are its last pixels
    double strength = 0.0;                             ///< 0 to 1: how often and how much it changes
};

/// Finds motion by differences from a short-term background. The camera must be at rest: the caller reports
/// when it moves. Repeated pictures, as from a driver that hangs, show no motion. One camera, one thread.
class MotionFinder {
public:
    explicit MotionFinder(const MotionSettings& settings = {});
    ~MotionFinder();
    MotionFinder(MotionFinder&&) noexcept;
    MotionFinder& operator=(MotionFinder&&) noexcept;

    /// Takes a picture (colours or grey of 8 bits) and returns what moves, the strongest first. After a
    /// picture of another kind or size all begins again.
    [[nodiscard]] std::vector<MotionBlob> look(const Picture& picture, Time stamp);
    /// Call while the camera moves: drops the background.
    void moved();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
