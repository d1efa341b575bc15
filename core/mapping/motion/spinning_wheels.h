#pragma once

namespace leitstand {

/// How far the wheels of a robot have turned while the map says that it stands: it pushes against something
/// that it does not see, or its wheels have lost their hold.
class SpinningWheels {
public:
    /// Between two scans odometry told a way of @p byOdometry [m], the map one of @p found [m].
    void add(double byOdometry, double found) {
        constexpr double Turn = 0.05;   // wheels turn: less is none in the two seconds of a scan [m]
        constexpr double Stands = 0.3;  // of odometry's way: slip on a ramp leaves more of it
        const bool spin = byOdometry > Turn && found < Stands * byOdometry;
        m_way = spin ? m_way + byOdometry : 0.0;
    }
    /// Nobody knows how far the robot came.
    void forget() { m_way = 0.0; }
    /// That they turned since the robot moved last, or tried to [m].
    [[nodiscard]] double way() const { return m_way; }

private:
    double m_way = 0.0;
};

}  // namespace leitstand
