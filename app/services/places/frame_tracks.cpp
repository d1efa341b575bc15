#include "app/services/places/frame_tracks.h"

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr int DeepestTree = 64;  // frames between a sensor and its base; more is a loop

std::string_view bare(std::string_view frame) {
    const auto slash = frame.rfind('/');
    return slash == std::string_view::npos ? frame : frame.substr(slash + 1);
}

}  // namespace

void FrameTracks::add(const Event& event) {
    if (event.sample.is<OdometrySample>() || event.role == StreamRole::StaticTransforms) m_fixed.add(event);
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        m_base = odometry->childFrame;
        const Time stamp = odometry->header.stamp == Time{} ? event.received : odometry->header.stamp;
        m_fixed.forgetBefore(stamp - Memory);
    }
    const auto* transforms = event.sample.as<TransformsSample>();
    if (transforms == nullptr || event.role == StreamRole::StaticTransforms) return;
    for (const FrameTransform& one : transforms->transforms) {
        Track& track = m_turning[one.childFrame];
        track.parent = one.header.frame;
        const Time stamp = one.header.stamp == Time{} ? event.received : one.header.stamp;
        track.poses.add(stamp, one.childInParent);
        track.poses.forgetBefore(stamp - Memory);
    }
}

std::optional<Pose> FrameTracks::inBase(const std::string& sensor, const std::string& frame, Time stamp) {
    // From the sensor up to the first frame that turns; the fixed frames do not lead past it.
    Pose pose = Pose::Identity();
    std::string at = frame;
    for (int i = 0; i < DeepestTree; ++i) {
        if (at == m_base || bare(at) == bare(m_robot->baseFrame))
            return m_fixed.correctionOf(sensor, frame).corrected(pose);
        const auto track = m_turning.find(at);
        if (track != m_turning.end()) {
            const auto then = track->second.poses.at(stamp);
            if (!then) return std::nullopt;
            pose = *then * pose;
            at = track->second.parent;
            continue;
        }
        const auto parent = m_fixed.parentOf(at);
        if (!parent) break;
        pose = parent->second * pose;
        at = parent->first;
    }
    return m_fixed.inBase(sensor, frame);
}

}  // namespace leitstand
