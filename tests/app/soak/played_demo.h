#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "app/services/log/replay/mission_replay.h"
#include "core/base/time.h"
#include "tests/app/soak/station_process.h"

namespace leitstand::test {

constexpr double LeastHeard = 0.95;  ///< of what robots send once and never again, many times as fast
constexpr std::chrono::seconds GivenBack(22);  ///< a station gives free memory back every 20 s

/// Records the demo into a folder in @p folder, which it returns. What the robots meet on their way is theirs
/// to know: where one gets stuck, another one is recorded. LEITSTAND_SOAK_DEMO names one that is there.
[[nodiscard]] std::filesystem::path recordedDemo(const std::filesystem::path& folder);

/// A replay of @p mission into a domain of this computer.
[[nodiscard]] std::unique_ptr<MissionReplay> replayOf(const std::filesystem::path& mission, int domain,
                                                      double rate, bool loop);

/// A mission that is played in a thread of its own as long as this lives, over and over.
class Playing {
public:
    Playing(const std::filesystem::path& mission, int domain, double rate);
    /// How much of the mission was said, in rounds.
    [[nodiscard]] double rounds() const { return m_rounds; }
    void pause(bool on) { m_paused = on; }
    ReplayOutcome end();

private:
    void note(double fraction);

    std::unique_ptr<MissionReplay> m_replay;
    std::atomic<bool> m_paused = false;
    double m_fraction = 0.0, m_whole = 0.0;
    std::atomic<double> m_rounds = 0.0;
    ReplayOutcome m_outcome;
    std::jthread m_thread;
};

/// Messages in @p mission on topics that a replay says, but pictures; by topic.
[[nodiscard]] std::map<std::string, std::uint64_t> messagesIn(const std::filesystem::path& mission);

/// How long @p mission took [s].
[[nodiscard]] double secondsOf(const std::filesystem::path& mission);

/// What the log of a station has at a moment.
struct Logged {
    Time last{};  ///< station's clock
    std::uint64_t keyScans = 0;
    std::uint64_t events = 0;        ///< that are in it
    std::uint64_t lastSequence = 0;  ///< of the newest: so many came, since they are numbered as they come
};
[[nodiscard]] Logged loggedIn(const std::filesystem::path& mission);

/// Waits until @p station has worked off what came many times as fast as robots say it: what waits for the
/// disk or for a thread is no memory that an hour of robots costs. False where it did not within two minutes.
[[nodiscard]] bool worksOff(const StationProcess& station);

}  // namespace leitstand::test
