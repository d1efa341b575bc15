#include "tests/app/explored/arena_truth.h"

#include <utility>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"
#include "tests/app/robots/robot_process.h"
#include "transport/convert/decode.h"

namespace leitstand::test {

ArenaTruth::ArenaTruth(const TestDomain& domain, const std::string& arena,
                       const std::vector<std::string>& robots) {
    NodeSettings settings;
    settings.domain = domain.number() + TruthAbove;
    settings.name = "arena's truth";
    m_node = must(Node::create(settings));
    for (const std::string& robot : robots) {
        StreamDescription stream;
        stream.role = StreamRole::Odometry;
        stream.topic = "/truth/" + arena + "/" + robot;
        stream.type = "nav_msgs/msg/Odometry";
        stream.qos = bestEffort(50);
        Track& track = m_tracks[robot];
        m_subscriptions.push_back(must(m_node->subscribe(
            {stream.topic, stream.type, stream.qos, Lane::Small},
            [this, &track, stream, child = robot + "/base_link"](const ReceivedSample& received) {
                const auto sample = decode(received.event, stream);
                if (!sample) return;
                const auto* reported = sample.value().as<OdometrySample>();
                if (reported == nullptr || reported->childFrame != child) return;
                const std::scoped_lock lock(m_mutex);
                if (track.newest)
                    track.way += (reported->baseInOdom.translation() - track.newest->translation()).norm();
                track.newest = reported->baseInOdom;
                track.track.add(reported->header.stamp, reported->baseInOdom);
            })));
    }
}

ArenaTruth::~ArenaTruth() {
    m_subscriptions.clear();
}

std::optional<Pose> ArenaTruth::newest(const std::string& robot) const {
    const std::scoped_lock lock(m_mutex);
    return m_tracks.at(robot).newest;
}

std::optional<Pose> ArenaTruth::at(const std::string& robot, Time stamp) const {
    const std::scoped_lock lock(m_mutex);
    return m_tracks.at(robot).track.at(stamp);
}

double ArenaTruth::way(const std::string& robot) const {
    const std::scoped_lock lock(m_mutex);
    return m_tracks.at(robot).way;
}

}  // namespace leitstand::test
