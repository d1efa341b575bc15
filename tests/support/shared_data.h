#pragma once

#include <filesystem>
#include <optional>

namespace leitstand::test {

/// The folder with the real scans, where this machine has it: LEITSTAND_SHARED_DATA, or shared/data beside
/// the checkout. Tests skip, loudly, without it.
[[nodiscard]] std::optional<std::filesystem::path> sharedData();

}  // namespace leitstand::test

/// Sets @p variable to the hall scans' folder, or skips the test with a loud line.
#define LEITSTAND_HALL_OR_SKIP(variable)                                                               \
    const auto variable##Root = leitstand::test::sharedData();                                         \
    if (!variable##Root) GTEST_SKIP() << "SKIPPED: the real scans are absent (LEITSTAND_SHARED_DATA)"; \
    const std::filesystem::path variable = *variable##Root / "kurt3d-hall"
