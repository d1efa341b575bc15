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
    double activity = 0.8;     ///< ... of how often a place moved [s]
    double longestGap = 1.5;   ///< longest gap between pictures; after a longer one all starts again [s]
    double warmUp = 1.0;       ///< time before motion is reported [s]
    double contrast = 14.0;    ///< least change of brightness, of 255
    double noise = 8.0;        ///< ... in deviations of the picture's own noise
    double often = 0.3;        ///< share of the last pictures in which a place must move
    double smallest = 0.0004;  ///< share of the picture; smaller things are noise
    double largest = 0.2;      ///< ... more than that together: the light changed, or the camera moved
};

/// Something that moves before a camera at rest.
struct MotionBlob {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< of the motion; first pixel's middle: 0.5 [px]
    int left = 0, top = 0, right = 0, bottom = 0;      ///< box, both ends within [px]
    double strength = 0.0;                             ///< 0 to 1: how often and how much it changes
};

/// Finds motion by differences from a short background. For a camera at rest: the caller reports when it
/// moves. Repeated pictures, as from a driver that hangs, show no motion. One camera, one thread.
class MotionFinder {
public:
    explicit MotionFinder(const MotionSettings& settings = {});
    ~MotionFinder();
    MotionFinder(MotionFinder&&) noexcept;
    MotionFinder& operator=(MotionFinder&&) noexcept;

    /// Takes a picture (colours or grey of 8 bits) and returns what moves, the strongest first. Other
    /// pictures, and those of another size, start all again.
    [[nodiscard]] std::vector<MotionBlob> look(const Picture& picture, Time stamp);
    /// The camera moves: forgets the background.
    void moved();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
