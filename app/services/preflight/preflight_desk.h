#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/services/domain/robot_guess.h"
#include "core/base/result.h"
#include "core/station/preflight/preflight.h"

namespace leitstand {

class Station;

/// Returns how fast @p megabytes, written to @p folder, reach the disk [B/s]. Errors name the folder.
[[nodiscard]] Result<double> measureDisk(const std::filesystem::path& folder, int megabytes = 16);

/// Collects the facts that the preflight page judges. The station must outlive it. For one thread; the disk
/// is measured on another thread.
class PreflightDesk {
public:
    explicit PreflightDesk(Station& station);
    PreflightDesk(const PreflightDesk&) = delete;
    PreflightDesk& operator=(const PreflightDesk&) = delete;

    /// Returns the present facts. @p gamepad: name of the gamepad, empty when there is none. Never waits for
    /// disk or network.
    [[nodiscard]] PreflightFacts facts(const std::string& gamepad) const;
    /// Measures the disk again; facts() has the result a moment later.
    void measure();
    /// Returns the robots in the domain that are not among the station's robots.
    [[nodiscard]] std::vector<RobotGuess> strangers() const;

private:
    Station& m_station;
    mutable std::mutex m_mutex;
    std::optional<double> m_rate;  ///< under the mutex
    std::atomic<bool> m_busy = false;
    std::jthread m_measuring;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
