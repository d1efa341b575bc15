#pragma once

#include <vector>

#include "core/base/pose.h"

namespace leitstand::simulation::test {

/// A way along corners, rounded where it turns; up and down between corners of different heights.
class DrivePath {
public:
    /// @p corners: on the floor, two at least, each apart from the next; none turns back. @p radius: of the
    /// curves; smaller where corners are near [m].
    explicit DrivePath(const std::vector<Eigen::Vector3d>& corners, double radius = 0.8);

    [[nodiscard]] double length() const { return m_length; }  ///< seen from above [m]
    /// base_link after @p way [m], its x along the way, standing on the floor with both axles.
    [[nodiscard]] Pose at(double way) const;

private:
    struct Piece {
        double begin, length;  ///< [m]
        Eigen::Vector2d from;
        double heading;    ///< at its beginning [rad]
        double curvature;  ///< to the left; 0: straight [1/m]
    };
    struct Height {
        double way, z;
    };
    void add(double length, double curvature);
    [[nodiscard]] Eigen::Vector2d placeAt(const Piece& piece, double way) const;
    [[nodiscard]] double heightAt(double way) const;

    std::vector<Piece> m_pieces;
    std::vector<Height> m_heights;
    double m_length = 0.0;
    Eigen::Vector2d m_end = Eigen::Vector2d::Zero();  ///< of the last piece
    double m_heading = 0.0;
};

}  // namespace leitstand::simulation::test
