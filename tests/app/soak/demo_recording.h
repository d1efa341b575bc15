#pragma once

#include <chrono>
#include <filesystem>

namespace leitstand::test {

/// Records the demo into the new mission @p folder: both simulated robots as processes in the yellow arena,
/// all that they send. Kurt3D explores for half of @p length and comes back to where it began, so that the
/// mission can be played over and over; the Crawler is driven to and fro. Throws what went wrong.
void recordDemo(const std::filesystem::path& folder, std::chrono::seconds length);

}  // namespace leitstand::test
