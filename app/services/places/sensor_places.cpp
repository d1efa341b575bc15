#include "app/services/places/sensor_places.h"

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"

namespace leitstand {

Time stampOf(const Event& event, const SampleHeader& header) {
    return header.stamp == Time{} ? event.received : header.stamp;
}

void SensorPlaces::onEvent(const Event& event) {
    m_frames.add(event);
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        m_tracker.add(*odometry, event.received);
        follow();
    } else if (const auto* imu = event.sample.as<ImuSample>()) {
        const auto unit = m_frames.inBase(event.sensor, imu->header.frame, imu->header.stamp);
        if (unit) m_tracker.add(*imu, *unit, event.received);
    }
}

void SensorPlaces::correct(const MapFix& fix) {
    m_fix = fix;
    follow();
}

void SensorPlaces::lose() {
    m_fix.reset();
    m_tracker.lose();
}

void SensorPlaces::follow() {
    // A guessed motion would turn the robot in the map until the next fix.
    if (!m_fix || !covers(m_fix->stamp)) return;
    m_tracker.correct(*m_fix);
    m_fix.reset();
}

std::optional<Pose> SensorPlaces::baseInOdom(Time stamp) const {
    const auto motion = m_tracker.motion().at(stamp);
    return motion ? std::optional<Pose>(motion->baseInOdom) : std::nullopt;
}

std::optional<SensorPlace> SensorPlaces::at(const std::string& sensor, const std::string& frame, Time stamp) {
    const auto inBase = m_frames.inBase(sensor, frame, stamp);
    const auto inOdom = baseInOdom(stamp);
    if (!inBase || !inOdom) return std::nullopt;
    return SensorPlace{*inBase, *inOdom, m_tracker.baseInMap(stamp), m_tracker.now().certain};
}

}  // namespace leitstand
