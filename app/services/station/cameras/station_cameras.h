#pragma once

#include <functional>
#include <string>

#include "app/services/log/live_mission.h"
#include "app/services/station/cameras/camera_turning.h"
#include "app/services/station/cameras/snapshots.h"
#include "core/event/motion_samples.h"
#include "transport/link/grant_keeper.h"

namespace leitstand {

struct NoteSample;

/// What a station does with cameras: turns them, and stores snapshots, each with a note in the log.
class StationCameras {
public:
    using Send = std::function<Result<void>(const std::string& robot, const PanTiltCommand& command)>;
    using Note = std::function<Result<void>(const NoteSample& note)>;
    using Notify = std::function<void(const std::string& text)>;
    StationCameras(const LiveMissionSettings& mission, GrantKeeper& grants, Send send, Note note,
                   Notify notify);

    [[nodiscard]] CameraTurning& turning() { return m_turning; }
    [[nodiscard]] Snapshots& snapshots() { return m_snapshots; }

private:
    CameraTurning m_turning;
    Snapshots m_snapshots;
};

}  // namespace leitstand
