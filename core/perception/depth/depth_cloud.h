#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/event/cloud_sample.h"

namespace leitstand {

struct CameraInfoSample;
struct Picture;
struct PictureSample;

/// Which points of a depth picture are taken.
struct DepthSettings {
    int mostPoints = 10'000;                ///< about; every so many pixels one is taken
    double nearest = 0.15, farthest = 8.0;  ///< depths [m]; depth cameras err with the square of the depth
    /// A pixel whose neighbours on both sides lie deeper or nearer than this share of its depth is at an
    /// edge, where cameras make up depths between both.
    double edge = 0.05;
};

/// Makes clouds of the depth pictures of one camera: along the optical axis, in millimetres of 16 bits or
/// metres (REP 118). 0, NaN and infinity are no depth. One thread at a time.
class DepthCloud {
public:
    explicit DepthCloud(const DepthSettings& settings = {}) : m_settings(settings) {}

    /// Returns the points of @p sample, unorganised, in the camera's optical frame. Error when it cannot be
    /// decoded, holds no depths, or @p camera is not calibrated.
    [[nodiscard]] Result<CloudSample> of(const PictureSample& sample, const CameraInfoSample& camera);

private:
    void aim(const CameraInfoSample& camera, const Picture& picture, int step);

    DepthSettings m_settings;
    int m_width = 0, m_height = 0;  ///< picture of the rays
    std::vector<double> m_calibration;
    /// Rays of the pixels that are taken, on the plane z = 1; NaN: the lens shows nothing there.
    std::vector<Eigen::Vector2f> m_rays;
};

}  // namespace leitstand
