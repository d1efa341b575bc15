#pragma once

#include <filesystem>
#include <string>

#include "tests/support/places.h"

namespace leitstand::test {

inline const std::filesystem::path ShippedRobots = std::filesystem::path(sourceFolder()) / "resources/robots";

/// The first lines of a robot's file with nothing wrong; what follows begins in line 3.
inline const std::string Head = "letter: K\nname: kurt3d\n";
/// The same with streams; what follows begins in line 4.
inline const std::string Whole = Head + "streams: [{role: points}]\n";

}  // namespace leitstand::test
