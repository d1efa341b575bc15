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

/// Functions that are called on the player's thread and must not block it. Each may be empty.
struct ReviewListener {
    std::function<void(double fraction)> onOpening = {};  ///< finished share of mapping and reading, 0 to 1
    /// Called once, when everything is read; moments follow.
    std::function<void(const ReviewIndexPtr&)> onIndex = {};
    std::function<void(const ReviewMomentPtr&)> onMoment = {};  ///< called for each moment that is shown
    std::function<void(const std::string&)> onMessage = {};     ///< called with a text for the operator
};

/// Plays a recorded mission, forwards and backwards, on its own thread. Skips times in which nothing was
/// recorded. Any thread; no call waits for the disk.
class ReviewPlayer {
public:
    /// How many times as fast as the mission: least and largest rate.
    static constexpr double Slowest = 0.1, Fastest = 32.0;
    static constexpr double MapPart = 0.9;  ///< share of onOpening() for the registration, if there is no map

    /// Opens the mission at ReviewIndex::opensAt, or at the moment that was requested while it was being
    /// read. Errors are those of ReviewLog::open().
    [[nodiscard]] static Result<std::unique_ptr<ReviewPlayer>> open(const std::filesystem::path& mission,
                                                                    ReviewListener listener = {});
    ~ReviewPlayer();
    ReviewPlayer(const ReviewPlayer&) = delete;
    ReviewPlayer& operator=(const ReviewPlayer&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_log->folder(); }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_log->robots(); }
    [[nodiscard]] Time first() const { return m_first; }
    [[nodiscard]] Time last() const { return m_last; }

    /// Plays @p rate times as fast as the mission; negative: backwards, 0: pauses. Its size is limited to
    /// Slowest and Fastest. Stops at the end, or when it plays backwards, at the start.
    void play(double rate);
    [[nodiscard]] double rate() const;
    /// Goes to @p at, limited to the mission. Only the newest request is carried out.
    void seek(Time at);
    void step(std::chrono::nanoseconds by);  ///< by this time from the present position
    void watch(const std::string& robot);    ///< see ReviewScene::watch()
    void show(ReviewMap map);
    [[nodiscard]] ReviewMap map() const;
    /// The present position, or the one that was requested.
    [[nodiscard]] Time position() const;
    /// The newest moment that was made; null: the mission was not completely read yet.
    [[nodiscard]] ReviewMomentPtr moment() const;
    /// Whether clouds are registered before the mission opens, because no station made a map
    /// (ReviewLog::makeMap()). This is then the first part of the opening, up to MapPart.
    [[nodiscard]] bool mapsOffline() const { return m_mapsOffline; }
    /// Ends the registration. The mission opens with what was registered so far.
    void stopMapping() { m_mapping.request_stop(); }

private:
    ReviewPlayer(std::unique_ptr<ReviewLog> log, ReviewListener listener);
    void run(const std::stop_token& stop);
    /// Makes a map if it is needed, and reads the whole mission.
    [[nodiscard]] ReviewIndexPtr opened(const std::stop_token& stop);
    void show(ReviewScene& scene, Time at, bool around);
    void advance(std::chrono::nanoseconds real, const ReviewIndex& index);  ///< under the mutex
    void wake();

    const std::unique_ptr<ReviewLog> m_log;  ///< used by the thread; robots() and folder() never change
    const ReviewListener m_listener;
    const Time m_first, m_last;
    std::stop_source m_mapping;
    const bool m_mapsOffline;
    mutable std::mutex m_mutex;
    std::condition_variable_any m_woken;
    Time m_position;        ///< under the mutex, as all members below
    bool m_sought = false;  ///< whether somebody requested a position
    double m_rate = 0.0;
    std::string m_watched;
    ReviewMap m_map = ReviewMap::AsThen;
    bool m_changed = true;
    ReviewMomentPtr m_moment;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
