#include "tests/simulation/mapping/drive_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace leitstand::simulation::test {
namespace {

constexpr double HalfBase = 0.2;  ///< from the robot's middle to its first and last axle [m]

}  // namespace

DrivePath::DrivePath(const std::vector<Eigen::Vector3d>& corners, double radius) {
    if (corners.size() < 2) throw std::invalid_argument("a way has two corners at least");
    const auto leg = [&](std::size_t i) -> Eigen::Vector2d {
        return (corners[i + 1] - corners[i]).head<2>();
    };
    m_end = corners.front().head<2>();
    m_heading = std::atan2(leg(0).y(), leg(0).x());
    m_heights.push_back({0.0, corners.front().z()});
    double cut = 0.0;  // of the leg, by the curve at its beginning
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        double turn = 0.0, next = 0.0;
        if (i + 2 < corners.size()) {
            const Eigen::Vector2d a = leg(i), b = leg(i + 1);
            turn = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
            if (std::abs(turn) > 2.8) throw std::invalid_argument("a way does not turn back");
            const double room = 0.45 * std::min(a.norm(), b.norm());
            next = std::min(radius * std::tan(std::abs(turn) / 2), room);
        }
        add(leg(i).norm() - cut - next, 0.0);
        if (std::abs(turn) > 1e-9) {
            const double curve = next / std::tan(std::abs(turn) / 2);
            add(curve * std::abs(turn) / 2, std::copysign(1.0 / curve, turn));
            m_heights.push_back({m_length, corners[i + 1].z()});
            add(curve * std::abs(turn) / 2, std::copysign(1.0 / curve, turn));
        } else {
            m_heights.push_back({m_length, corners[i + 1].z()});
        }
        cut = next;
    }
}

void DrivePath::add(double length, double curvature) {
    m_pieces.push_back({m_length, length, m_end, m_heading, curvature});
    m_end = placeAt(m_pieces.back(), m_length + length);
    m_heading += curvature * length;
    m_length += length;
}

Eigen::Vector2d DrivePath::placeAt(const Piece& piece, double way) const {
    const double along = way - piece.begin, heading = piece.heading;
    if (piece.curvature == 0.0)
        return piece.from + along * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    const double turned = heading + piece.curvature * along;
    return piece.from +
           Eigen::Vector2d(std::sin(turned) - std::sin(heading), std::cos(heading) - std::cos(turned)) /
               piece.curvature;
}

double DrivePath::heightAt(double way) const {
    const auto after =
        std::find_if(m_heights.begin(), m_heights.end(), [&](const Height& one) { return one.way > way; });
    if (after == m_heights.begin()) return m_heights.front().z;
    if (after == m_heights.end()) return m_heights.back().z;
    const Height &a = *std::prev(after), &b = *after;
    return std::lerp(a.z, b.z, (way - a.way) / (b.way - a.way));
}

Pose DrivePath::at(double way) const {
    way = std::clamp(way, 0.0, m_length);
    auto piece = std::upper_bound(m_pieces.begin(), m_pieces.end(), way,
                                  [](double value, const Piece& one) { return value < one.begin; });
    piece = std::prev(piece);
    const Eigen::Vector2d place = placeAt(*piece, way);
    const double front = heightAt(way + HalfBase), back = heightAt(way - HalfBase);
    const double pitch = -std::atan2(front - back, 2 * HalfBase);
    return poseFrom({place.x(), place.y(), (front + back) / 2}, 0.0, pitch,
                    piece->heading + piece->curvature * (way - piece->begin));
}

}  // namespace leitstand::simulation::test
