#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/mission/score/score_profile.h"

namespace leitstand {

/// Parses the rules of a score from JSON @p text (docs/score.md). Errors have the file name @p name, line,
/// key and what was expected.
[[nodiscard]] Result<ScoreProfile> parseScoreProfile(std::string_view text, const std::string& name);

/// Reads the rules of a score from @p file.
[[nodiscard]] Result<ScoreProfile> readScoreProfile(const std::filesystem::path& file);

/// Profiles sorted by name, and why other profiles could not be read.
struct ScoreProfiles {
    std::vector<ScoreProfile> profiles;
    std::vector<std::string> problems;

    /// Returns the profile called @p name. If there is none, returns the newest (last by name). Null when
    /// there are no profiles.
    [[nodiscard]] const ScoreProfile* find(const std::string& name) const;
};

/// Returns the profiles that come with the program, and the user's own. A user's profile replaces a shipped
/// one with the same name.
[[nodiscard]] ScoreProfiles scoreProfiles();
/// Returns the profiles in @p folders. Later folders override earlier ones; missing folders hold none.
[[nodiscard]] ScoreProfiles scoreProfilesIn(const std::vector<std::filesystem::path>& folders);

}  // namespace leitstand
