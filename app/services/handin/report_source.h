#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/handin/report_model.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct FindSample;
struct VictimEvidence;
struct Event;
class BagReader;
class EventDecoder;

/// A mission that is opened for a report.
class ReportSource {
public:
    /// Opens the mission @p folder (or one of its files) and reads its state, key scans and paths. A bag of
    /// others has no key scans. Then some of its clouds are registered, one every 0.3 m or 10 degrees,
    /// starting from odometry if there is any. Error only when nothing at all can be read; warnings() lists
    /// what is missing. When cancelled, it has what was read so far.
    [[nodiscard]] static Result<ReportSource> open(const std::filesystem::path& folder,
                                                   const Progress& progress = {});
    ~ReportSource();
    ReportSource(ReportSource&&) noexcept;
    ReportSource& operator=(ReportSource&&) noexcept;

    [[nodiscard]] const ReportInput& input() const { return m_input; }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return m_warnings; }
    /// Whether warnings() say why there is no map.
    [[nodiscard]] bool mentionsMap() const { return m_mentionsMap; }
    [[nodiscard]] const std::vector<RobotDescription>& robots() const;

    /// Returns the decoded event with the sequence @p sequence. Error when it is missing or makes no sense.
    [[nodiscard]] Result<Event> event(std::uint64_t sequence);
    /// Returns the event that is @p evidence of @p find, found by sequenceInLog().
    [[nodiscard]] Result<Event> event(const VictimEvidence& evidence, const FindSample& find);
    /// Returns the pose of the sensor that made @p event, a cloud or ranges, in its robot's base at that
    /// time. Uses transforms received around that time, otherwise the robot's file. Empty for other events,
    /// and where transforms have a gap.
    [[nodiscard]] std::optional<Pose> sensorInBase(const Event& event);

private:
    ReportSource();
    void readState();
    void readKeyScans(const std::filesystem::path& folder, const Progress& progress);
    void registerClouds(const std::filesystem::path& folder, const Progress& progress);
    void readWays(const Progress& progress);
    void readViews(const Progress& progress);

    std::unique_ptr<BagReader> m_bag;
    std::unique_ptr<EventDecoder> m_decoder;
    ReportInput m_input;
    std::vector<std::string> m_warnings;
    bool m_mentionsMap = false;
    bool m_hasKeyScans = false;  ///< whether a station mapped it, even if none of its scans remain
};

}  // namespace leitstand
