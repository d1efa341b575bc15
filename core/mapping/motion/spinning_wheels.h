#pragma once

namespace leitstand {

/// How far the wheels of a robot have turned while the robot stands in the map. Then it pushes against
/// something that it does not see, or its wheels have lost their grip.
class SpinningWheels {
public:
    /// Adds the distance between two scans: @p byOdometry [m] by odometry, @p found [m] by the map.
    void add(double byOdometry, double found) {
        constexpr double Turn = 0.05;   // least that wheels turn in the two seconds of a scan [m]
        constexpr double Stands = 0.3;  // of odometry's way: slip on a ramp leaves more of it
        const bool spin = byOdometry > Turn && found < Stands * byOdometry;
        m_way = spin ? m_way + byOdometry : 0.0;
    }
    /// Forgets the distance: how far the robot came is unknown.
    void forget() { m_way = 0.0; }
    /// Returns how far the wheels turned in vain since the robot last moved, or its wheels last stood still
    /// [m].
    [[nodiscard]] double way() const { return m_way; }

private:
    double m_way = 0.0;
};

}  // namespace leitstand
