#pragma once

namespace leitstand {

/// Runs the station with its command line; returns the process's exit status: 0 ok, 1 failed, 2 wrong usage.
[[nodiscard]] int runStation(int argc, char** argv);

}  // namespace leitstand
