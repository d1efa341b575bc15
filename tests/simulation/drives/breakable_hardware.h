#pragma once

#include <memory>
#include <set>
#include <utility>

#include "core/event/motion_samples.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand::simulation::test {

/// Hardware whose sensors can break: nothing of theirs comes any more.
class BreakableHardware final : public RobotHardware {
public:
    explicit BreakableHardware(std::unique_ptr<RobotHardware> whole) : m_whole(std::move(whole)) {}

    void breakSensor(StreamRole role) { m_broken.insert(role); }

    [[nodiscard]] Time now() const override { return m_whole->now(); }
    [[nodiscard]] std::vector<HardwareSample> take() override {
        auto samples = m_whole->take();
        std::erase_if(samples, [this](const HardwareSample& one) { return m_broken.contains(one.role); });
        return samples;
    }
    [[nodiscard]] TrackState tracks() const override { return m_whole->tracks(); }
    void setMotors(double left, double right) override { m_whole->setMotors(left, right); }
    void setBrake(bool on) override { m_whole->setBrake(on); }
    void setPanTilt(const std::string& unit, double pan, double tilt) override {
        m_whole->setPanTilt(unit, pan, tilt);
    }
    void setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) override {
        m_whole->setStream(role, sensor, settings);
    }
    [[nodiscard]] std::optional<TwistSample> remote() const override { return m_whole->remote(); }

private:
    std::unique_ptr<RobotHardware> m_whole;
    std::set<StreamRole> m_broken;
};

}  // namespace leitstand::simulation::test
