#pragma once

namespace leitstand {

/// Runs the station with its command line. Returns the exit status of the process: 0 success, 1 failure, 2
/// wrong usage.
[[nodiscard]] int runStation(int argc, char** argv);

}  // namespace leitstand
