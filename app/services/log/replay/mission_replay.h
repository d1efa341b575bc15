#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/settings/domain_settings.h"

namespace leitstand {

/// Settings of a replay.
struct ReplaySettings {
    std::filesystem::path mission;
    DomainSettings domain = {};
    double rate = 1.0;           ///< how many times as fast as the mission it plays, above 0
    bool loop = false;           ///< whether to start again at the end
    double settleSeconds = 2.0;  ///< time spent listening for live robots before the first sample [s]
};

/// Result of a replay.
struct ReplayOutcome {
    std::uint64_t published = 0;
    std::uint64_t heldBack = 0;  ///< number of events that a replay must not publish
    std::vector<std::string> heldBackTopics;
    std::vector<std::string> problems;  ///< texts about what could not be read or sent
};

/// Publishes on DDS what a mission's robots sent, at the pace at which it was received. Stamps are not
/// changed.
class MissionReplay {
public:
    /// Opens the mission and joins the domain. Error when the bag cannot be read. Also an error when somebody
    /// already publishes there: as a robot of the mission, or on a topic of the mission that names no robot
    /// ("/odom"). Then nothing is published.
    [[nodiscard]] static Result<std::unique_ptr<MissionReplay>> open(const ReplaySettings& settings,
                                                                     const Progress& progress = {});
    ~MissionReplay();
    MissionReplay(const MissionReplay&) = delete;
    MissionReplay& operator=(const MissionReplay&) = delete;

    /// Plays to the end, or repeatedly with ReplaySettings::loop, until @p progress is cancelled. While
    /// @p paused is set, the replay pauses; afterwards it continues from there.
    [[nodiscard]] ReplayOutcome play(const std::atomic<bool>& paused, const Progress& progress = {});

private:
    struct State;
    explicit MissionReplay(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
