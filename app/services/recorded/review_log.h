#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/services/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/event/event.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

class BagReader;

/// A mission's log at any of its moments, forwards and backwards: its events, and the state that results from
/// them. Reads the log in short segments and keeps those used last, with states in between. So a moment near
/// the last one is available at once; a distant one takes a checkpoint and the events after it. Never changes
/// the mission, not even if its writer was killed. One thread at a time.
class ReviewLog {
public:
    using Take = std::function<void(const Event&)>;

    /// Opens the log of @p mission. Errors name the folder and what is wrong with it: it is no bag, or it is
    /// empty.
    [[nodiscard]] static Result<std::unique_ptr<ReviewLog>> open(const std::filesystem::path& mission);
    ~ReviewLog();
    ReviewLog(const ReviewLog&) = delete;
    ReviewLog& operator=(const ReviewLog&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const;
    [[nodiscard]] Time first() const;  ///< receive time of the first event
    [[nodiscard]] Time last() const;
    /// Texts about what could not be read so far.
    [[nodiscard]] std::vector<std::string> problems() const;

    /// Whether the mission has no key scans, but has clouds of robots from which makeMap() can make a map.
    [[nodiscard]] bool lacksMap() const;
    /// Registers the clouds (mapOffline()) into key scans. These then appear as if a station had published
    /// each of them when it was complete. Writes nothing. Problems are added to problems(). When cancelled,
    /// keeps the scans registered so far.
    void makeMap(const Progress& progress);

    /// Returns the state after the last event that was received at or before @p at.
    [[nodiscard]] MissionState stateAt(Time at);
    /// Calls @p take for the events received after @p after and at or before @p upTo, in order.
    void events(Time after, Time upTo, const Take& take);
    /// Returns the newest event on @p topic received at or before @p at; empty when there is none.
    [[nodiscard]] std::optional<Event> newest(const std::string& topic, Time at);
    /// Returns when the first event on @p topic was received; empty when there is none.
    [[nodiscard]] std::optional<Time> firstOf(const std::string& topic);
    /// Calls @p take for all events on @p topics; when cancelled, for those read so far.
    void all(const std::vector<std::string>& topics, const Progress& progress, const Take& take);

private:
    struct Segment;
    class History;
    ReviewLog(std::filesystem::path mission, std::unique_ptr<BagReader> bag,
              std::vector<RobotDescription> robots);
    [[nodiscard]] std::int64_t numberOf(Time at) const;
    const Segment& segment(std::int64_t number);
    [[nodiscard]] MissionState startOf(std::int64_t number, std::uint64_t before);

    std::filesystem::path m_mission;  ///< path with which it was opened: the folder, or one of its files
    std::filesystem::path m_folder;
    std::unique_ptr<BagReader> m_bag;
    EventDecoder m_decoder;
    std::vector<std::string> m_warnings;
    std::vector<Event> m_made;                       ///< key scans of makeMap(), by sequence
    std::chrono::nanoseconds m_length;               ///< length of a segment
    std::list<std::unique_ptr<Segment>> m_segments;  ///< the one that was used last comes first
    std::map<std::int64_t, MissionState> m_starts;   ///< state before each segment
    std::map<std::pair<std::string, std::int64_t>, std::optional<Event>>
        m_before;  ///< newest event of a topic before a segment
};

/// Whether @p mission has what a review shows: a map that a station made while robots drove, or clouds and
/// either pictures or odometry. Clouds alone are for a window on scans.
[[nodiscard]] bool isReviewable(const std::filesystem::path& mission);
/// Whether @p mission is a bag to which Leitstand never wrote; such a bag must not be changed.
[[nodiscard]] bool isOfOthers(const std::filesystem::path& mission);

}  // namespace leitstand
