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
    LiveMissionSettings mission;  ///< topics in its robots' files are recorded; no robots: all found
    DomainSettings domain = {};
};

/// Status of a recording.
struct RecorderStatus {
    LiveMissionStatus log;
    std::vector<RecordedTopic> topics;
    std::vector<LinkStatus> links;        ///< of the robots whose files were given
    std::vector<std::string> mismatches;  ///< in words
    /// Topics of steady streams (best effort) that were announced for 2 s or more without a sample.
    std::vector<std::string> notReceived;
    std::vector<ScreenDrop> screened;  ///< packets that were kept from the DDS library
};

/// Records a domain into a mission until the recorder is stopped or destroyed. It listens and never publishes
/// to a robot.
class MissionRecorder {
public:
    /// Receives texts for the operator: alarms, changed links, topics that cannot be received. Called on
    /// threads of the recorder.
    using Notify = std::function<void(const std::string&)>;

    [[nodiscard]] static Result<std::unique_ptr<MissionRecorder>> start(const RecorderSettings& settings,
                                                                        Notify notify = {});
    ~MissionRecorder();
    MissionRecorder(const MissionRecorder&) = delete;
    MissionRecorder& operator=(const MissionRecorder&) = delete;

    [[nodiscard]] RecorderStatus status() const;
    /// Ends the session; the mission is self-contained afterwards. The domain is left when the recorder is
    /// destroyed.
    Result<void> stop();

private:
    struct State;
    explicit MissionRecorder(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
