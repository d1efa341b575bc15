#pragma once

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {

/// The home of the user whom programs of this process see (HOME, XDG_CONFIG_HOME, XDG_DATA_HOME).
[[nodiscard]] std::filesystem::path homeFolder();

/// A user whose home is a copy of what an earlier program left there, and who has a copy of a mission of it.
/// The screen is 1920 x 1080, as it was then.
class CompatHome : public testing::Test {
protected:
    CompatHome();

    [[nodiscard]] static std::filesystem::path config() { return homeFolder() / ".config/leitstand"; }
    [[nodiscard]] static std::filesystem::path kept(const std::string& name);  ///< the fixture's own file

    const TemporaryFolder m_folder;
    const std::filesystem::path m_mission = m_folder / "mission";
};

}  // namespace leitstand::test
