#include "app/services/station/cameras/station_cameras.h"

#include <utility>

#include "app/services/log/sequencer.h"
#include "core/base/words.h"
#include "core/event/motion_samples.h"

namespace leitstand {
namespace {

CameraTurning::Wire wireTo(GrantKeeper& grants, StationCameras::Send send) {
    CameraTurning::Wire wire;
    wire.grant = [&grants](const GrantId& id) { return grants.view(id); };
    wire.mayAct = [&grants](const GrantId& id) { return grants.mayAct(id); };
    wire.ask = [&grants](const GrantId& id) { grants.requestGrant(id); };
    wire.answer = [&grants](const GrantId& id, bool consent) { grants.answerRequest(id, consent); };
    wire.send = [send = std::move(send)](const std::string& robot, PanTiltCommand command) {
        command.header.stamp = stationTime();
        return send(robot, command);
    };
    return wire;
}

Snapshots::Listener noting(const std::string& station, StationCameras::Note note,
                           StationCameras::Notify notify) {
    Snapshots::Listener kept;
    kept.onWritten = [station, note = std::move(note), notify](const std::string& robot,
                                                               const std::filesystem::path& file) {
        const auto reported = note({stationTime(), station, robot, "Snapshot " + file.string()});
        notify(reported ? fill(translate("leitstand::Station", "Snapshot kept: {}"), file.string())
                        : reported.error().text);
    };
    kept.onProblem = std::move(notify);
    return kept;
}

}  // namespace

StationCameras::StationCameras(const LiveMissionSettings& mission, GrantKeeper& grants, Send send, Note note,
                               Notify notify)
    : m_turning(mission.robots, wireTo(grants, std::move(send))),
      m_snapshots(mission.folder, noting(mission.station, std::move(note), std::move(notify))) {}

}  // namespace leitstand
