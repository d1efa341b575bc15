#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/services/log/live_mission.h"
#include "app/services/log/mission_feed.h"
#include "core/base/result.h"
#include "core/robot/link/link_status.h"
#include "core/robot/link/screen_report.h"
#include "core/settings/domain_settings.h"

namespace leitstand {

/// Settings of a recording.
struct RecorderSettings {
    /// Topics in its robots' files are recorded; without robots, all topics that are found.
    LiveMissionSettings mission;
    DomainSettings domain = {};
};

/// Status of a recording.
struct RecorderStatus {
    LiveMissionStatus log;
    std::vector<RecordedTopic> topics;
    std::vector<LinkStatus> links;        ///< for the robots whose files were given
    std::vector<std::string> mismatches;  ///< in words
    /// Topics of steady streams (best effort) that have been announced for at least 2 s, but not received.
    std::vector<std::string> notReceived;
    std::vector<ScreenDrop> screened;  ///< packets that were not passed to the DDS library
};

/// Records a domain into a mission until the recorder is stopped or destroyed. It listens, but never
/// publishes to a robot.
class MissionRecorder {
public:
    /// Called with texts for the operator: alarms, changed links, topics that cannot be received. Called on
    /// threads of the recorder.
    using Notify = std::function<void(const std::string&)>;

    [[nodiscard]] static Result<std::unique_ptr<MissionRecorder>> start(const RecorderSettings& settings,
                                                                        Notify notify = {});
    ~MissionRecorder();
    MissionRecorder(const MissionRecorder&) = delete;
    MissionRecorder& operator=(const MissionRecorder&) = delete;

    [[nodiscard]] RecorderStatus status() const;
    /// Ends the session; then the mission is self-contained. The domain is left when the recorder is
    /// destroyed.
    Result<void> stop();

private:
    struct State;
    explicit MissionRecorder(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
