#include "app/services/places/sensor_poses.h"

#include "core/base/words.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"

namespace leitstand {
namespace {

constexpr int DeepestTree = 64;  ///< frames between a sensor and its base; more is a loop

/// "kurt3d/base_link" and "base_link" mean one frame of a robot.
std::string_view withoutPrefix(std::string_view frame) {
    const auto slash = frame.rfind('/');
    return slash == std::string_view::npos ? frame : frame.substr(slash + 1);
}

}  // namespace

void SensorPoses::add(const Event& event) {
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        const Time stamp = odometry->header.stamp == Time{} ? event.received : odometry->header.stamp;
        m_baseInOdom.add(stamp, odometry->baseInOdom);
        m_baseFrame = odometry->childFrame;
    } else if (const auto* transforms = event.sample.as<TransformsSample>()) {
        for (const FrameTransform& one : transforms->transforms) {
            m_parents.insert_or_assign(one.childFrame, Parent{one.header.frame, one.childInParent});
        }
    }
}

std::optional<Pose> SensorPoses::inBaseByTransforms(const std::string& frame) const {
    const std::string_view base = withoutPrefix(m_robot->baseFrame);
    Pose pose = Pose::Identity();
    std::string at = frame;
    for (int i = 0; i < DeepestTree; ++i) {
        if (at == m_baseFrame || withoutPrefix(at) == base) return pose;
        const auto parent = m_parents.find(at);
        if (parent == m_parents.end()) return std::nullopt;
        pose = parent->second.childInParent * pose;
        at = parent->second.frame;
    }
    return std::nullopt;
}

std::optional<std::pair<std::string, Pose>> SensorPoses::parentOf(const std::string& frame) const {
    const auto parent = m_parents.find(frame);
    if (parent == m_parents.end()) return std::nullopt;
    return std::pair(parent->second.frame, parent->second.childInParent);
}

std::string SensorPoses::nameOf(const std::string& sensor, const std::string& frame) const {
    if (m_robot->sensors.contains(sensor)) return sensor;
    for (const auto& [name, described] : m_robot->sensors) {
        if (withoutPrefix(described.frame) == withoutPrefix(frame)) return name;
    }
    return {};
}

void SensorPoses::setCorrection(const std::string& sensor, const std::string& frame,
                                const ScannerCorrection& correction) {
    const std::string name = nameOf(sensor, frame);
    m_corrections.insert_or_assign(name.empty() ? sensor : name, correction);
}

bool SensorPoses::isOfScanner(const std::string& frame) const {
    const std::string_view bare = withoutPrefix(frame);
    return bare != withoutPrefix(m_robot->baseFrame) && bare != withoutPrefix(m_robot->odomFrame);
}

ScannerCorrection SensorPoses::correctionOf(const std::string& sensor, const std::string& frame) const {
    if (!isOfScanner(frame)) return {};
    const std::string name = nameOf(sensor, frame);
    const auto set = m_corrections.find(name.empty() ? sensor : name);
    if (set != m_corrections.end()) return set->second;
    const auto described = m_robot->sensors.find(name);
    return described == m_robot->sensors.end() ? ScannerCorrection{} : described->second.correction;
}

Pose SensorPoses::inBase(const std::string& sensor, const std::string& frame) {
    return correctionOf(sensor, frame).corrected(describedInBase(sensor, frame));
}

Pose SensorPoses::describedInBase(const std::string& sensor, const std::string& frame) {
    if (const auto pose = inBaseByTransforms(frame)) return *pose;
    if (const auto described = m_robot->sensors.find(nameOf(sensor, frame));
        described != m_robot->sensors.end())
        return described->second.sensorInBase;
    m_remarks.insert(leitstand::fill(
        translate(
            "leitstand::Error",
            "{}: nobody tells where frame \"{}\" sits (neither tf_static nor the robot's file); taken as {}"),
        m_robot->name, frame, m_robot->baseFrame));
    return Pose::Identity();
}

bool SensorPoses::isPlaced(const std::string& sensor, const std::string& frame) const {
    return !isOfScanner(frame) || inBaseByTransforms(frame) ||
           m_robot->sensors.contains(nameOf(sensor, frame));
}

std::optional<Pose> SensorPoses::sensorInOdom(const Event& event, const SampleHeader& header, Time stamp) {
    const auto base = m_baseInOdom.at(stamp);
    if (!base) return std::nullopt;
    // A cloud that its robot has already moved into the odometry's frame.
    if (withoutPrefix(header.frame) == withoutPrefix(m_robot->odomFrame)) return Pose::Identity();
    return *base * inBase(event.sensor, header.frame);
}

}  // namespace leitstand
