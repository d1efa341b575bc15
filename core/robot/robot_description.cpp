#include "core/robot/robot_description.h"

#include <algorithm>
#include <array>

#include "core/event/stream_role.h"

namespace leitstand {

std::string toString(StampSource source) {
    switch (source) {
        case StampSource::Robot:
            return "robot";
        case StampSource::Zero:
            return "zero";
        case StampSource::Station:
            return "station";
    }
    return {};
}

std::string toString(TfPrefix prefix) {
    switch (prefix) {
        case TfPrefix::Topic:
            return "topic";
        case TfPrefix::Frame:
            return "frame";
        case TfPrefix::None:
            return "none";
    }
    return {};
}

std::string toString(SensorMotion motion) {
    switch (motion) {
        case SensorMotion::Unknown:
            return "unsaid";
        case SensorMotion::Fixed:
            return "fixed";
        case SensorMotion::Turning:
            return "turning";
        case SensorMotion::Tilting:
            return "tilting";
    }
    return {};
}

std::string toString(DriveType drive) {
    switch (drive) {
        case DriveType::Differential:
            return "differential";
        case DriveType::Tracked:
            return "tracked";
        case DriveType::Omnidirectional:
            return "omnidirectional";
    }
    return {};
}

std::string toString(LinkLossRule rule) {
    switch (rule) {
        case LinkLossRule::Stop:
            return "stop";
        case LinkLossRule::FinishAndWait:
            return "finish_and_wait";
        case LinkLossRule::ReturnToLink:
            return "return_to_link";
    }
    return {};
}

const StreamDescription* RobotDescription::stream(StreamRole role, const std::string& sensor) const {
    const auto found = std::find_if(streams.begin(), streams.end(), [&](const StreamDescription& stream) {
        return stream.role == role && (sensor.empty() || stream.sensor == sensor);
    });
    return found == streams.end() ? nullptr : &*found;
}

const StreamDescription* RobotDescription::commandsOf(const JointGroup& group) const {
    const auto found = std::find_if(streams.begin(), streams.end(), [&](const StreamDescription& stream) {
        return stream.role == StreamRole::JointCommand && stream.group == group.name;
    });
    return found == streams.end() ? nullptr : &*found;
}

const ServiceDescription* RobotDescription::navigation() const {
    const auto found = std::find_if(services.begin(), services.end(), [](const ServiceDescription& service) {
        const ServiceFacts* const facts = serviceFacts(service.type);
        return facts != nullptr && facts->kind == ServiceKind::Navigate;
    });
    return found == services.end() ? nullptr : &*found;
}

bool RobotDescription::takesGoals() const {
    return navigation() != nullptr || stream(StreamRole::GoalPose) != nullptr;
}

bool RobotDescription::mayMap(const StreamDescription& one) const {
    return one.role == StreamRole::Points ||
           (one.role == StreamRole::Ranges && stream(StreamRole::Odometry) != nullptr);
}

const StreamDescription* RobotDescription::mappingStream() const {
    const StreamDescription* only = nullptr;
    int scanners = 0;
    for (const StreamDescription& one : streams) {
        if (!mayMap(one)) continue;
        if (one.maps) return &one;
        if (one.role == StreamRole::Points) only = &one;
        ++scanners;
    }
    return scanners == 1 ? only : nullptr;
}

}  // namespace leitstand
