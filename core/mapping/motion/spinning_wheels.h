#pragma once

namespace leitstand {

/// How far the wheels of a robot have turned while the robot stands in the map. Either it pushes against
/// something that it does not see, or its wheels slip.
class SpinningWheels {
public:
    /// Adds a step between two scans: @p byOdometry [m] in odometry, @p found [m] in the map.
    void add(double byOdometry, double found) {
        constexpr double Turn = 0.05;   // least that wheels turn in the two seconds of a scan [m]
        constexpr double Stands = 0.3;  // of odometry's way: slip on a ramp leaves more of it
        const bool spin = byOdometry > Turn && found < Stands * byOdometry;
        m_way = spin ? m_way + byOdometry : 0.0;
    }
    /// Sets the distance to zero, because it is unknown how far the robot moved.
    void forget() { m_way = 0.0; }
    /// Returns how far the wheels have spun since the robot last moved, or since they last stood still [m].
    [[nodiscard]] double way() const { return m_way; }

private:
    double m_way = 0.0;
};

}  // namespace leitstand
