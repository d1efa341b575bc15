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
#include "core/mission/finds/candidate_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What codes say that are tags of victims, by the profile of the score that a mission names.
struct TagsOfProfiles {
    std::map<std::string, TagPatterns> byName;
    /// Of the profile @p name, else of the newest (last by name), else the usual ones.
    [[nodiscard]] TagPatterns of(const std::string& name) const;
};

/// Searches what all robots say for victims, codes and hazards: finds cues, places them in the map and joins
/// them into candidates. All that it knows of the map is in events too, so it does on a log what it does
/// live. Without thread; one at a time.
class VictimSearch {
public:
    VictimSearch(const std::vector<RobotDescription>& robots, const std::string& station,
                 const CueSettings& cues = {}, const CandidateSettings& candidates = {});

    /// All events of a mission, in order. @p search false: only where robots are is followed.
    void onEvent(const Event& event, bool search = true);
    /// Where key scans are: of earlier sessions, or after an undo.
    void follow(std::span<const ScanPose> poses);
    /// Where @p robot was, by every scan that fits: live, more than the key scans tell. Of a robot that is
    /// none of the search's: nothing.
    void correct(const std::string& robot, const MapFix& fix);
    /// Where it takes @p robot to be; null when it is none of its own.
    [[nodiscard]] const RobotInMap* place(const std::string& robot) const;
    /// What was told of a candidate in an earlier session.
    void restore(const CandidateSample& sample) { m_book.take(sample); }
    void restore(const VictimSample& find);  ///< likewise of a find; after its candidates
    /// Which codes are tags of victims; the mission's data say by which @p profile, until then it is this
    /// one.
    void setTags(TagsOfProfiles tags, const std::string& profile);
    /// Where something is that a robot's picture shows; empty: nobody can tell.
    [[nodiscard]] std::optional<PlacedCue> locate(const LookedAt& looked);
    /// Whether a robot's picture shows a place [m].
    [[nodiscard]] bool shows(const Event& picture, const Eigen::Vector3d& inMap);
    /// Candidates that are new or changed.
    [[nodiscard]] std::vector<CandidateSample> due(Time now) { return m_book.due(now); }

    /// Told of every cue that counts, before it is joined; for tests and tuning. May be empty.
    std::function<void(const PlacedCue&)> onCue;

private:
    void correct(std::span<const PlaceOfRobot> fixes);
    [[nodiscard]] std::uint64_t scanFor(const PlacedCue& cue) const;
    [[nodiscard]] bool isRobot(const PlacedCue& cue) const;

    std::map<std::string, CueFinder> m_finders;  ///< fixed
    CandidateBook m_book;
    TagsOfProfiles m_tags;
    KeyScanPlaces m_scans;
    std::map<std::string, Event> m_unheard;  ///< sightings that came while nothing was searched, by robot
};

}  // namespace leitstand
