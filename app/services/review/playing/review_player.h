#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "app/services/review/review_scene.h"
#include "core/base/result.h"

namespace leitstand {

/// Functions that are called on the player's thread and must not block it; any may be empty.
struct ReviewListener {
    std::function<void(double fraction)> onOpening = {};        ///< share of mapping and reading done, 0 to 1
    std::function<void(const ReviewIndexPtr&)> onIndex = {};    ///< once, when all is read; moments follow
    std::function<void(const ReviewMomentPtr&)> onMoment = {};  ///< each moment that is shown
    std::function<void(const std::string&)> onMessage = {};     ///< for the operator, in words
};

/// Plays a recorded mission, forwards and backwards, on its own thread. Skips times in which nothing was
/// recorded. Any thread; no call waits for the disk.
class ReviewPlayer {
public:
    static constexpr double Slowest = 0.1, Fastest = 32.0;  ///< ratio of mission's time to real time
    static constexpr double MapPart = 0.9;  ///< share of registration in onOpening(), when there is no map

    /// Opens the mission at ReviewIndex::opensAt, or at the moment that was sought before the mission was
    /// read. Errors as of ReviewLog::open().
    [[nodiscard]] static Result<std::unique_ptr<ReviewPlayer>> open(const std::filesystem::path& mission,
                                                                    ReviewListener listener = {});
    ~ReviewPlayer();
    ReviewPlayer(const ReviewPlayer&) = delete;
    ReviewPlayer& operator=(const ReviewPlayer&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_log->folder(); }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_log->robots(); }
    [[nodiscard]] Time first() const { return m_first; }
    [[nodiscard]] Time last() const { return m_last; }

    /// Plays at @p rate, the ratio of mission's time to real time; negative: backwards, 0: stands. Its size
    /// is limited to Slowest and Fastest. Stops by itself at the end, and at the start when it goes
    /// backwards.
    void play(double rate);
    [[nodiscard]] double rate() const;
    /// Goes to @p at, limited to the mission; the newest request counts.
    void seek(Time at);
    void step(std::chrono::nanoseconds by);  ///< from where it is
    void watch(const std::string& robot);    ///< as of ReviewScene
    void show(ReviewMap map);
    [[nodiscard]] ReviewMap map() const;
    /// The present position, or the one that was requested.
    [[nodiscard]] Time position() const;
    /// The newest moment that was made; null before the mission was read through.
    [[nodiscard]] ReviewMomentPtr moment() const;
    /// Whether clouds are registered before the mission opens, since no station made a map
    /// (ReviewLog::makeMap()). Opening then does this up to MapPart.
    [[nodiscard]] bool mapsOffline() const { return m_mapsOffline; }
    /// Ends the registration: the mission opens with what is registered by now.
    void stopMapping() { m_mapping.request_stop(); }

private:
    ReviewPlayer(std::unique_ptr<ReviewLog> log, ReviewListener listener);
    void run(const std::stop_token& stop);
    /// Makes a map if needed, and reads the mission through.
    [[nodiscard]] ReviewIndexPtr opened(const std::stop_token& stop);
    void show(ReviewScene& scene, Time at, bool around);
    void advance(std::chrono::nanoseconds real, const ReviewIndex& index);  ///< under the mutex
    void wake();

    const std::unique_ptr<ReviewLog> m_log;  ///< of the thread; robots() and folder() never change
    const ReviewListener m_listener;
    const Time m_first, m_last;
    std::stop_source m_mapping;
    const bool m_mapsOffline;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_woken;
    Time m_position;        ///< under the mutex, as all that follows
    bool m_sought = false;  ///< somebody requested a position
    double m_rate = 0.0;
    std::string m_watched;
    ReviewMap m_map = ReviewMap::AsThen;
    bool m_changed = true;
    ReviewMomentPtr m_moment;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
