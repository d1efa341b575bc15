#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/event/sample.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/robot/robot_file.h"
#include "robots/wire/robot_wire.h"
#include "tests/support/dds/robot_listener.h"
#include "tests/support/places.h"
#include "tests/support/samples.h"
#include "tests/transport/dds/test_node.h"
#include "transport/convert/encode.h"
#include "transport/link/grant_keeper.h"

namespace leitstand::test {

[[nodiscard]] inline RobotDescription fileOf(const std::string& name) {
    return must(readRobot(sourceFolder() + "/resources/robots/" + name + ".yaml"));
}

/// A sample as streams of @p stream's type carry it, all fields different; what it says of whom it is from
/// fits @p stream.
[[nodiscard]] inline Sample sampleFor(const StreamDescription& stream) {
    for (const SampleCase& one : sampleCases()) {
        if (one.type != stream.type) continue;
        Sample sample = one.sample;
        if (auto* diagnostics = sample.edit<DiagnosticsSample>()) {
            for (DiagnosticStatus& status : diagnostics->statuses) status.hardwareId = stream.hardwareId;
        }
        return sample;
    }
    throw std::runtime_error("no sample of " + stream.type);
}

/// A station's writers of all commands of a robot.
class WireStation {
public:
    WireStation(Node& node, const RobotDescription& robot) {
        for (const StreamDescription& stream : robot.streams) {
            if (isCommand(stream.role)) add(node, stream.topic, stream.type, stream.qos);
        }
        add(node, std::string(station_topic::Grants), "leitstand_msgs/msg/Grant", grantQos());
    }
    [[nodiscard]] Publisher& on(const std::string& topic) { return *m_publishers.at(topic); }
    void publish(const StreamDescription& stream, const Sample& sample) {
        if (!on(stream.topic).write(must(encode(sample, stream.type))))
            throw std::runtime_error(stream.topic);
    }
    /// Waits until the robot hears all of them.
    [[nodiscard]] bool matched() const {
        return waitUntil([&] {
            return std::all_of(m_publishers.begin(), m_publishers.end(),
                               [](const auto& one) { return one.second->matched() > 0; });
        });
    }
    [[nodiscard]] std::map<std::string, std::unique_ptr<Publisher>>& all() { return m_publishers; }

private:
    void add(Node& node, const std::string& topic, const std::string& type, const Qos& qos) {
        m_publishers[topic] = must(node.publisher({topic, type, qos, Flow::Immediate}));
    }
    std::map<std::string, std::unique_ptr<Publisher>> m_publishers;
};

}  // namespace leitstand::test
