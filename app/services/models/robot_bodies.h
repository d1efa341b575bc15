#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "app/services/job_queue.h"
#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/model/model_body.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Makes what robots look like from the models that they publish (robot_description), on a thread of its own.
class RobotBodies {
public:
    /// Receives a sentence for the operator: what is wrong with a model, or which of its meshes are missing.
    using Notify = std::function<void(const std::string& text)>;

    /// @p notify is called on the thread that makes bodies, until the destructor returns.
    explicit RobotBodies(Notify notify);
    ~RobotBodies();
    RobotBodies(const RobotBodies&) = delete;
    RobotBodies& operator=(const RobotBodies&) = delete;

    /// Returns the body of @p robot by its newest @p model, and begins to make it when the model is new.
    /// Null: it has no model, or the body is not made yet. While a changed model is being made, the earlier
    /// body is returned. Of a model that keeps changing, a body is made every 5 s.
    [[nodiscard]] ModelBodyPtr body(const RobotDescription& robot, const LatestPtr<RobotModelSample>& model);

private:
    struct Entry {
        std::uint64_t sequence = 0;  ///< of the event with the model
        std::string wanted;          ///< the newest model, URDF
        std::string made;            ///< the model of `body`, which is null if it cannot be drawn
        ModelBodyPtr body;
        bool atWork = false;  ///< whether a job is waiting or running
        SteadyTime began{};   ///< when the last job was submitted
        std::string said;     ///< what the operator was notified of last
    };
    void make(const RobotDescription& robot, const std::stop_token& cancelled);

    Notify m_notify;
    std::mutex m_mutex;
    std::map<std::string, Entry> m_entries;  ///< by robot
    JobQueue m_jobs;
    std::jthread m_worker;  ///< the last member, so that it ends first
};

}  // namespace leitstand
