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

/// Guards of the station's robots: a process beside it for each robot that has no watchdog and is driven
/// nevertheless. Such a robot is driven only while its guard is there and heard by it. Any thread.
class StationGuards {
public:
    struct Setup {
        std::filesystem::path program;                          ///< the guard's
        std::map<std::string, std::vector<std::string>> words;  ///< of its command line, by robot
        /// Whether a robot may be driven has changed. Called on the guards' own thread.
        std::function<void(const std::string& robot)> onChange;
        /// A robot has no guard, which it should have, and why. On the same thread.
        std::function<void(const std::string& robot, const std::string& problem)> onTrouble;
    };
    explicit StationGuards(Setup setup);
    ~StationGuards();  ///< guards end
    StationGuards(const StationGuards&) = delete;
    StationGuards& operator=(const StationGuards&) = delete;

    void want(const std::string& robot, bool wanted);  ///< whether it is to have a guard. Never waits
    /// It needs no guard, or has one that it hears. Never waits.
    [[nodiscard]] bool allows(const std::string& robot) const;
    /// What its guard is told; nothing where there is none. Never waits for the guard.
    void pulse(const std::string& robot, const GuardPulse& pulse);
    [[nodiscard]] GuardView view(const std::string& robot) const;
    [[nodiscard]] std::optional<pid_t> processOf(const std::string& robot) const;

private:
    struct Entry {
        std::atomic<bool> wanted = false, ready = false;
        mutable std::mutex mutex;               ///< of the rest
        std::unique_ptr<GuardProcess> process;  ///< made and ended by our thread alone
        bool deaf = false;                      ///< it did not take what it was told
        std::string problem;                    ///< why there is none
        SteadyTime failed = {};
        std::string told;  ///< the problem that was told last; of our thread
    };
    void run(const std::stop_token& stop);
    void wake() const;
    bool look(const std::string& robot, Entry& entry, bool stopping);
    void tellTrouble(const std::string& robot, Entry& entry);
    void begin(const std::string& robot, Entry& entry);

    const Setup m_setup;
    std::map<std::string, Entry> m_entries;  ///< fixed
    int m_wake = -1;                         ///< an eventfd
    std::jthread m_thread;                   ///< last: joined first
};

}  // namespace leitstand
