#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Settings for detecting motion.
struct MotionSettings {
    double background = 2.0;  ///< time constant of the background of still pictures [s]
    double activity = 0.8;    ///< time constant for how often each place moved [s]
    /// Longest gap between pictures; after a longer gap, detection starts again [s].
    double longestGap = 1.5;
    double warmUp = 1.0;       ///< time before motion is reported [s]
    double contrast = 14.0;    ///< least change of brightness, out of 255 ...
    double noise = 8.0;        ///< ... and in multiples of the picture's own noise (standard deviation)
    double often = 0.3;        ///< a place must move in this share of the last pictures
    double smallest = 0.0004;  ///< things smaller than this share of the picture are noise
    /// If more than this share of the picture moves, the light changed or the camera moved.
    double largest = 0.2;
};

/// Something that moves in front of a camera at rest.
struct MotionBlob {
    /// Middle of the motion [px]; the middle of the first pixel is 0.5.
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    /// Bounding box [px]; right and bottom are its last pixels.
    int left = 0, top = 0, right = 0, bottom = 0;
    double strength = 0.0;  ///< how often and how much it changes, 0 to 1
};

/// Finds motion by differences from a short-term background. The camera must be at rest; the caller reports
/// when it moves. Repeated pictures, as from a driver that hangs, show no motion. One camera, one thread.
class MotionFinder {
public:
    explicit MotionFinder(const MotionSettings& settings = {});
    ~MotionFinder();
    MotionFinder(MotionFinder&&) noexcept;
    MotionFinder& operator=(MotionFinder&&) noexcept;

    /// Takes a picture (colours or grey of 8 bits) and returns what moves, the strongest first. After a
    /// picture of another kind or size, detection starts again.
    [[nodiscard]] std::vector<MotionBlob> look(const Picture& picture, Time stamp);
    /// Call while the camera moves: drops the background.
    void moved();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
