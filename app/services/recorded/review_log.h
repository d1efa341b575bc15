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

/// A mission's log at any of its moments, forwards and backwards: its events, and the state that they make.
/// Reads the log in short segments and keeps those used last, with states in between. A moment near the last
/// one is then at hand; a far one costs a checkpoint and the events after it. Never changes the mission, not
/// even one whose writer was killed. One thread at a time.
class ReviewLog {
public:
    using Take = std::function<void(const Event&)>;

    /// Opens the log of @p mission. Errors name the folder and what is wrong with it: no bag, or nothing in
    /// it.
    [[nodiscard]] static Result<std::unique_ptr<ReviewLog>> open(const std::filesystem::path& mission);
    ~ReviewLog();
    ReviewLog(const ReviewLog&) = delete;
    ReviewLog& operator=(const ReviewLog&) = delete;

    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const;
    [[nodiscard]] Time first() const;  ///< receive time of the first event
    [[nodiscard]] Time last() const;
    /// What could not be read so far, in words.
    [[nodiscard]] std::vector<std::string> problems() const;

    /// Whether the mission has no key scans, but clouds of robots from which makeMap() can make a map.
    [[nodiscard]] bool lacksMap() const;
    /// Registers the clouds (mapOffline()) into key scans. These then appear as if a station had published
    /// each of them when it was complete. Writes nothing. Problems go to problems(). When cancelled, keeps
    /// the scans registered so far.
    void makeMap(const Progress& progress);

    /// Returns the state after the last event that was received at or before @p at.
    [[nodiscard]] MissionState stateAt(Time at);
    /// Calls @p take for what was received after @p after and at or before @p upTo, in order.
    void events(Time after, Time upTo, const Take& take);
    /// Returns the newest event of @p topic received at or before @p at; empty when there is none.
    [[nodiscard]] std::optional<Event> newest(const std::string& topic, Time at);
    /// Returns when the first event of @p topic was received; empty when there is none.
    [[nodiscard]] std::optional<Time> firstOf(const std::string& topic);
    /// Calls @p take for all events of @p topics; when cancelled, for those read so far.
    void all(const std::vector<std::string>& topics, const Progress& progress, const Take& take);

private:
    struct Segment;
    class History;
    ReviewLog(std::filesystem::path mission, std::unique_ptr<BagReader> bag,
              std::vector<RobotDescription> robots);
    [[nodiscard]] std::int64_t numberOf(Time at) const;
    const Segment& segment(std::int64_t number);
    [[nodiscard]] MissionState startOf(std::int64_t number, std::uint64_t before);

    std::filesystem::path m_mission;  ///< as it was opened: the folder, or a file of it
    std::filesystem::path m_folder;
    std::unique_ptr<BagReader> m_bag;
    EventDecoder m_decoder;
    std::vector<std::string> m_warnings;
    std::vector<Event> m_made;                       ///< key scans of makeMap(), by sequence
    std::chrono::nanoseconds m_length;               ///< of a segment
    std::list<std::unique_ptr<Segment>> m_segments;  ///< the one used last first
    std::map<std::int64_t, MissionState> m_starts;   ///< states before segments
    std::map<std::pair<std::string, std::int64_t>, std::optional<Event>>
        m_before;  ///< newest event before a segment
};

/// Whether @p mission holds what a review shows: a map that a station of ours made while robots drove, or
/// clouds and either pictures or odometry. Clouds alone are for a window on scans.
[[nodiscard]] bool isReviewable(const std::filesystem::path& mission);
/// Whether @p mission is a bag that no station of ours wrote into; such a bag must stay as it is.
[[nodiscard]] bool isOfOthers(const std::filesystem::path& mission);

}  // namespace leitstand
