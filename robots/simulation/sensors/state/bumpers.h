#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// Bumpers around a robot: front, left, rear, right. They are published at the beginning and at every change.
class Bumpers final : public Sensor {
public:
    explicit Bumpers(std::string frame);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    struct Side {
        Time hit{};  ///< time of the last hit
        std::uint32_t hits = 0;
        bool pressed = false;
    };
    std::string m_frame;
    bool m_enabled = true, m_reported = false;
    std::size_t m_seen = 0;  ///< number of the world's bumps that were read so far
    std::array<Side, 4> m_sides;
};

}  // namespace leitstand::simulation
