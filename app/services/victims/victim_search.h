#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/services/places/key_scan_places.h"
#include "app/services/victims/cue_finder.h"
#include "core/event/candidate_sample.h"
#include "core/event/event.h"
#include "core/event/scan_pose.h"
#include "core/mission/finds/candidate_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Which codes are tags of victims, according to the score profile that a mission names.
struct TagsOfProfiles {
    std::map<std::string, TagPatterns> byName;
    /// Returns the patterns of the profile @p name. If there is none, returns those of the newest profile
    /// (last by name), or the usual ones.
    [[nodiscard]] TagPatterns of(const std::string& name) const;
};

/// Searches what all robots send for victims, codes and hazards: finds cues, places them in the map and
/// combines them into candidates. Events are sufficient to follow the map, so it works on a log as it does
/// live. It has no thread; one call at a time.
class VictimSearch {
public:
    VictimSearch(const std::vector<RobotDescription>& robots, const std::string& station,
                 const CueSettings& cues = {}, const CandidateSettings& candidates = {});

    /// Call with all events of a mission, in order. If @p search is false, only follows where robots are.
    void onEvent(const Event& event, bool search = true);
    /// Sets the poses of key scans: first those of earlier sessions, after an undo those of all.
    void follow(std::span<const ScanPose> poses);
    /// Sets where @p robot was. A live station calls this for every scan that fits, which is more often than
    /// there are key scans. Ignores robots that are not the search's.
    void correct(const std::string& robot, const MapFix& fix);
    /// Returns the place of @p robot as known to the search; null: the search has no such robot.
    [[nodiscard]] const RobotInMap* place(const std::string& robot) const;
    /// Restores a candidate from an earlier session.
    void restore(const CandidateSample& sample) { m_book.take(sample); }
    void restore(const FindSample& find);  ///< from an earlier session; call after restoring its candidates
    /// Sets which codes are tags of victims. @p profile is used until the mission names one.
    void setTags(TagsOfProfiles tags, const std::string& profile);
    /// Returns the place of a thing in a robot's picture; empty: unknown.
    [[nodiscard]] std::optional<PlacedCue> locate(const LookedAt& looked);
    /// Whether a robot's picture shows a place [m].
    [[nodiscard]] bool shows(const Event& picture, const Eigen::Vector3d& inMap);
    /// Returns the candidates that are new or have changed since they were returned last.
    [[nodiscard]] std::vector<CandidateSample> due(Time now) { return m_book.due(now); }

    /// Called with every cue that is used, before it is combined with others; for tests and tuning. May be
    /// empty.
    std::function<void(const PlacedCue&)> onCue;

private:
    void correct(std::span<const PlaceOfRobot> fixes);
    [[nodiscard]] std::uint64_t scanFor(const PlacedCue& cue) const;
    [[nodiscard]] bool isRobot(const PlacedCue& cue) const;

    std::map<std::string, CueFinder> m_finders;  ///< robots are never added or removed
    CandidateBook m_book;
    TagsOfProfiles m_tags;
    KeyScanPlaces m_scans;
    /// Sightings that were received while the search was off, by robot.
    std::map<std::string, Event> m_notReceived;
};

}  // namespace leitstand
