#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/services/station/safety/guard_process.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/robot/control/stop/guard_view.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Guards of the station's robots: a separate process for each robot that has no watchdog but is driven all
/// the same. Such a robot is driven only while its guard runs and the robot receives the guard's commands.
/// Any thread.
class StationGuards {
public:
    struct Setup {
        std::filesystem::path program;                          ///< path of the guard program
        std::map<std::string, std::vector<std::string>> words;  ///< arguments of each robot's guard
        /// Called when it has changed whether a robot may be driven. On the guards' own thread.
        std::function<void(const std::string& robot)> onChange;
        /// Called with the reason when a robot lacks the guard that it should have. On the same thread.
        std::function<void(const std::string& robot, const std::string& problem)> onTrouble;
    };
    explicit StationGuards(Setup setup);
    ~StationGuards();  ///< ends the guards
    StationGuards(const StationGuards&) = delete;
    StationGuards& operator=(const StationGuards&) = delete;

    void want(const std::string& robot,
              bool wanted);  ///< sets whether the robot should have a guard; never waits
    /// Whether the robot needs no guard, or receives the commands of its guard. Never waits.
    [[nodiscard]] bool allows(const std::string& robot) const;
    /// Sends @p pulse to the guard of @p robot, if there is one. Never waits for the guard.
    void pulse(const std::string& robot, const GuardPulse& pulse);
    [[nodiscard]] GuardView view(const std::string& robot) const;
    [[nodiscard]] std::optional<pid_t> processOf(const std::string& robot) const;

private:
    struct Entry {
        std::atomic<bool> wanted = false, ready = false;
        mutable std::mutex mutex;               ///< guards the rest
        std::unique_ptr<GuardProcess> process;  ///< made and ended only by the guards' own thread
        bool deaf = false;                      ///< whether it did not take a pulse
        std::string problem;                    ///< why there is no guard
        SteadyTime failed = {};
        std::string notified;  ///< problem that was reported last; used by the guards' own thread
    };
    void run(const std::stop_token& stop);
    void wake() const;
    bool look(const std::string& robot, Entry& entry, bool stopping);
    void notifyTrouble(const std::string& robot, Entry& entry);
    void begin(const std::string& robot, Entry& entry);

    const Setup m_setup;
    std::map<std::string, Entry> m_entries;  ///< robots are never added or removed
    int m_wake = -1;                         ///< an eventfd
    std::jthread m_thread;                   ///< the last member, so that it is joined first
};

}  // namespace leitstand
