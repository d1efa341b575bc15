#include "core/robot/control/drive_keys.h"

namespace leitstand {

bool DriveKeys::any() const {
    return held(DriveKey::Forward) || held(DriveKey::Back) || held(DriveKey::Left) || held(DriveKey::Right);
}

DriveVelocity DriveKeys::sticks(const DriveLimits& limits) const {
    const double share = held(DriveKey::Slow) ? Slowly : held(DriveKey::Fast) ? 1.0 : Usual;
    const auto axis = [this](DriveKey plus, DriveKey minus) {
        return static_cast<double>(held(plus)) - static_cast<double>(held(minus));
    };
    DriveVelocity requested;
    requested.forward = share * limits.speed * axis(DriveKey::Forward, DriveKey::Back);
    requested.turn = share * limits.turnRate * axis(DriveKey::Left, DriveKey::Right);
    return limited(requested, limits);
}

}  // namespace leitstand
