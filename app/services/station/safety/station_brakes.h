#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/base/result.h"
#include "core/robot/robot_description.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {

struct Event;

/// Brake tests of the station's robots, and which robots may be driven after them. A robot that failed may
/// not be driven until it passes, or until the operator overrides this. Any thread.
class StationBrakes : public EventSink {
public:
    /// The functions with which a test drives and queries a robot.
    struct Hands {
        /// Returns all facts except the space ahead, for which spaceAhead is called.
        std::function<BrakeFacts(const std::string& robot)> facts;
        std::function<double(const std::string& robot)> spaceAhead;  ///< free space ahead [m]; NaN: unknown
        std::function<void(const std::string& robot, const DriveVelocity& sticks)> push;
        std::function<void(const std::string& robot, bool on)>
            focus;  ///< sets the driver's focus; on: all other robots lose it
        /// Called when the conditions for driving changed.
        std::function<void(const std::string& robot)> refresh;
        /// @p kept: whether the result could be written to the file.
        std::function<void(const std::string& robot, const BrakeResult& result, const Result<void>& kept)>
            done;
    };
    /// @p file: file in which results are stored.
    StationBrakes(const std::vector<RobotDescription>& robots, std::filesystem::path file, Hands hands);

    /// Begins a test, or restarts one that is running. From then on, call hold() and end() for the operator's
    /// key.
    void begin(const std::string& robot);
    void hold(const std::string& robot);  ///< call while the key is held, at least ten times a second
    void end(const std::string& robot);   ///< call when the key was released
    [[nodiscard]] BrakeTest::Phase phase(const std::string& robot) const;
    /// Newest result, including earlier runs of the program.
    [[nodiscard]] BrakeResult result(const std::string& robot) const;

    /// Sets whether a robot may be driven although it failed. This ends with the next test, and with the
    /// program.
    void setOverridden(const std::string& robot, bool on);
    [[nodiscard]] bool isOverridden(const std::string& robot) const;

    [[nodiscard]] bool isRunning(const std::string& robot) const;
    /// Whether the robot failed and must not be driven. Never waits.
    [[nodiscard]] bool refuses(const std::string& robot) const;
    /// Whether the test showed that the robot has no watchdog, and it is driven all the same. Never waits.
    [[nodiscard]] bool needsGuard(const std::string& robot) const;
    /// Whether nothing may be sent to the robot now. Never waits. False if look() is no longer called.
    [[nodiscard]] bool silences(const std::string& robot) const;

    void onEvent(const Event& event) override;  ///< takes odometry; ignores other events
    void look(const std::string& robot);        ///< call it a few times a second

private:
    struct Entry {
        BrakeTest test;    ///< under the mutex, like the next three members
        BrakeResult last;  ///< newest result; an inconclusive one does not replace a failure
        double space = 0.0;
        SteadyTime spaceAt = {};
        std::atomic<bool> running = false, refused = false, overridden = false, unwatched = false;
        std::atomic<std::int64_t> silentUntil = 0;  ///< time on the steady clock [ns]
    };
    [[nodiscard]] Entry* find(const std::string& robot);
    [[nodiscard]] const Entry* find(const std::string& robot) const;
    void step(const std::string& robot, Entry& entry);
    static void keep(Entry& entry, const BrakeResult& result);  ///< under the mutex
    static void judge(Entry& entry);                            ///< from the last result; under the mutex
    void finish(const std::string& robot, const BrakeResult& result);

    const std::filesystem::path m_file;
    const Hands m_hands;
    mutable std::mutex m_mutex;
    std::map<std::string, Entry> m_entries;  ///< by robot; robots are never added or removed
};

}  // namespace leitstand
