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

/// What is true in an arena, shared by the processes whose robots are in it: topics in docs/simulation.md,
/// "Truth". Robots of other processes become ghosts in this one's world. One thread, beside the node's.
class TruthExchange {
public:
    /// @p robot: this process's one, of @p kind ("kurt3d", "crawler"), @p number in its world. Errors name
    /// the topic.
    [[nodiscard]] static Result<std::unique_ptr<TruthExchange>> create(Node& node, const Arena& arena,
                                                                       const std::string& kind,
                                                                       const RobotDescription& robot,
                                                                       int number);
    ~TruthExchange();
    TruthExchange(const TruthExchange&) = delete;
    TruthExchange& operator=(const TruthExchange&) = delete;

    void take(World& world);       ///< moves the others to where they said to be
    void say(const World& world);  ///< 20 times a second of the world's time, and each new contact
    /// What the points of @p cloud, which was measured within the last seconds, belong to.
    void sayLabels(const World& world, const CloudSample& cloud);

private:
    struct State;
    explicit TruthExchange(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

/// "yellow_7": @p arena as a part of topics.
[[nodiscard]] std::string topicPart(const Arena& arena);

}  // namespace leitstand::simulation
