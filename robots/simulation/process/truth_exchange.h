#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/event/cloud_sample.h"
#include "core/robot/robot_description.h"
#include "robots/simulation/arena/arena.h"
#include "robots/simulation/world/world.h"
#include "transport/dds/node.h"

namespace leitstand::simulation {

/// Shares the truth about an arena between the processes whose robots are in it (topics: docs/simulation.md,
/// "Truth"). Robots of other processes are ghosts in this process's world. Used by one thread in addition to
/// the node's.
class TruthExchange {
public:
    /// @p robot: name of this process's robot, of @p kind ("kurt3d", "crawler"), with the number @p number in
    /// its world. Errors name the topic.
    [[nodiscard]] static Result<std::unique_ptr<TruthExchange>> create(Node& node, const Arena& arena,
                                                                       const std::string& kind,
                                                                       const RobotDescription& robot,
                                                                       int number);
    ~TruthExchange();
    TruthExchange(const TruthExchange&) = delete;
    TruthExchange& operator=(const TruthExchange&) = delete;

    void take(World& world);                ///< moves ghosts to the received poses
    void publishTruth(const World& world);  ///< publishes the pose at 50 Hz of world time, and new contacts
    /// Publishes the labels of @p cloud (at most 5 s old), if somebody subscribes to them.
    void publishLabels(const World& world, const CloudSample& cloud);

private:
    struct State;
    explicit TruthExchange(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// Returns the name of @p arena as a part of topics: "yellow_7".
[[nodiscard]] std::string topicPart(const Arena& arena);

}  // namespace leitstand::simulation
