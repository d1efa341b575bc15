#include "app/services/review/review_evidence.h"

#include "app/services/finds/freezing.h"
#include "app/services/finds/recent_evidence.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {

FrozenEvidence evidenceAt(const ReviewMoment& moment, const std::string& robot, const MissionState& shown,
                          const Eigen::Vector3d& placeInMap) {
    FrozenEvidence frozen;
    frozen.found = moment.now;
    frozen.robot = robot;
    frozen.deviation = PointedDeviation;
    const auto known = moment.mission->robots.find(robot);
    if (known != moment.mission->robots.end() && known->second->mode)
        frozen.autonomous = known->second->mode->sample.autonomous;
    for (const Event& event : moment.pictures) {
        const bool old = moment.now - event.received > RecentEvidence::Pictures;
        if (event.robot != robot || old || !event.sample.is<PictureSample>()) continue;
        const bool thermal = event.role == StreamRole::Thermal;
        frozen.evidence.push_back(evidenceOf(thermal ? "thermal" : "picture", event));
    }
    hang(frozen, shown, scanBeside(shown, robot, placeInMap), placeInMap);
    return frozen;
}

}  // namespace leitstand
