#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mission/score/score_profile.h"

namespace leitstand {

/// Reads the rules of a score (docs/score.md): JSON. Errors name @p name, line, key and what was expected.
[[nodiscard]] Result<ScoreProfile> parseScoreProfile(std::string_view text, const std::string& name);

/// The same from @p file.
[[nodiscard]] Result<ScoreProfile> readScoreProfile(const std::filesystem::path& file);

/// Profiles by rising name, and why some could not be read.
struct ScoreProfiles {
    std::vector<ScoreProfile> profiles;
    std::vector<std::string> problems;

    /// The one of @p name, else the newest (last by name); null when there are none.
    [[nodiscard]] const ScoreProfile* find(const std::string& name) const;
};

/// Those that come with the program and the user's own, which replace shipped ones of their name.
[[nodiscard]] ScoreProfiles scoreProfiles();
/// Those in the @p folders, of which later ones replace earlier ones; folders that are not there hold none.
[[nodiscard]] ScoreProfiles scoreProfilesIn(const std::vector<std::filesystem::path>& folders);

}  // namespace leitstand
