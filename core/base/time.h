#pragma once

#include <chrono>

namespace leitstand {

/// A moment on a robot's or the station's clock: nanoseconds since the Unix epoch.
using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::nanoseconds>;

}  // namespace leitstand
