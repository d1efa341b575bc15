#pragma once

#include <algorithm>
#include <cmath>

namespace leitstand {

/// The ratio of a robot's true distances to those of its odometry. They differ because of worn wheels, a
/// wrong diameter or slip. It is the least-squares ratio over the last metres where surfaces held all
/// directions.
class OdometryScale {
public:
    /// Adds a step of @p byOdometry [m] in odometry, and @p found [m] in the map.
    void add(double byOdometry, double found) {
        constexpr double Forgetting = 40.0;  // [m]
        const double kept = std::exp(-byOdometry / Forgetting);
        m_products = kept * m_products + byOdometry * found;
        m_squares = kept * m_squares + byOdometry * byOdometry;
        m_way = kept * m_way + byOdometry;
    }
    [[nodiscard]] double factor() const {
        constexpr double Usual = 10.0, Most = 0.15;  // the prior: so far with a scale of one [m]
        if (m_squares <= 0.0) return 1.0;
        const double sure = m_way / (m_way + Usual);
        return 1.0 + std::clamp(sure * (m_products / m_squares - 1.0), -Most, Most);
    }

private:
    double m_products = 0.0, m_squares = 0.0, m_way = 0.0;
};

}  // namespace leitstand
