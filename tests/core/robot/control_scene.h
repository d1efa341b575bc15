#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand::test {

/// A moment of a test, @p milliseconds after its begin.
[[nodiscard]] inline SteadyTime at(std::int64_t milliseconds) {
    return SteadyTime(std::chrono::hours(1000) + std::chrono::milliseconds(milliseconds));
}
/// A station's clock, @p milliseconds after the begin of the test.
[[nodiscard]] inline Time wallAt(std::int64_t milliseconds) {
    return Time(std::chrono::seconds(1'700'000'000) + std::chrono::milliseconds(milliseconds));
}
[[nodiscard]] inline Sender sender(std::uint8_t number) {
    Sender made;
    made.bytes.back() = number;
    return made;
}
inline const GrantId Drive = driveGrant("kurt3d");

/// What @p station says about driving kurt3d.
[[nodiscard]] inline GrantSample grantSaying(const std::string& station, GrantSample::Action action,
                                             std::uint64_t term = 1, const std::string& other = {}) {
    return {{},    station, fmt::format("Title of {}", station), GrantSample::Kind::Drive, action, "kurt3d",
            other, term};
}

}  // namespace leitstand::test
