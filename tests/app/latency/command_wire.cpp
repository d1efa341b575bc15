#include "tests/app/latency/command_wire.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "tests/support/places.h"
#include "tests/support/wait.h"
#include "transport/convert/decode.h"

namespace leitstand::test {

CommandWire::CommandWire(const TestDomain& domain) {
    const RobotDescription robot = readRobot(sourceFolder() + "/resources/robots/kurt3d.yaml").value();
    const StreamDescription stream = *robot.stream(StreamRole::DriveCommand);
    NodeSettings settings;
    settings.domain = domain.number();
    m_node = Node::create(settings).value();
    const auto receive = [this, stream](const ReceivedSample& sample) {
        const auto now = Clock::now();
        const auto command = decode(sample.event, stream);
        if (!command) return;
        const auto* twist = command->as<TwistSample>();
        if (twist == nullptr) return;
        const bool turning = std::abs(twist->angular.z()) > 1e-6;
        const std::lock_guard lock(m_mutex);
        if (!m_any || turning != m_turning) m_since = now;
        m_any = true;
        m_turning = turning;
    };
    m_commands = m_node->subscribe({stream.topic, stream.type, stream.qos, Lane::Small}, receive).value();
}

bool CommandWire::receives() const {
    const std::lock_guard lock(m_mutex);
    return m_any;
}

std::optional<CommandWire::Clock::time_point> CommandWire::waitFor(bool turning) const {
    const bool came = waitUntil(
        [&] {
            const std::lock_guard lock(m_mutex);
            return m_any && m_turning == turning;
        },
        std::chrono::seconds(10));
    if (!came) return std::nullopt;
    const std::lock_guard lock(m_mutex);
    return m_since;
}

}  // namespace leitstand::test
