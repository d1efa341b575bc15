#pragma once

#include <string>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/status_samples.h"

namespace leitstand::simulation::test {

/// A robot as the operator has it who sends it through a building, in virtual time or over the wire.
class TouredRobot {
public:
    TouredRobot() = default;
    virtual ~TouredRobot() = default;
    TouredRobot(const TouredRobot&) = delete;
    TouredRobot& operator=(const TouredRobot&) = delete;

    [[nodiscard]] virtual double seconds() const = 0;      ///< that passed where it is
    [[nodiscard]] virtual Pose baseInArena() const = 0;    ///< truly
    [[nodiscard]] virtual ModeSample mode() const = 0;     ///< as it said last
    virtual void ask(const std::string& mode) = 0;         ///< what it is to do
    virtual void send(const Eigen::Vector3d& inBase) = 0;  ///< to a place, from where it stands [m]
    /// Takes the sticks for it; false while they are another robot's, or not let go yet: to be asked again.
    virtual bool take() = 0;
    virtual void drive(double forward,
                       double turn) = 0;  ///< with the sticks [m/s, rad/s], until told otherwise
    virtual void release() = 0;           ///< the sticks
};

}  // namespace leitstand::simulation::test
