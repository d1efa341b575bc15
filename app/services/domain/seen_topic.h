#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/model/model_body.h"
#include "core/robot/streams/qos.h"

namespace leitstand {

/// A topic that was received, or that is in a bag.
struct SeenTopic {
    std::string name;  ///< ROS name; the DDS name if it has no ROS name
    std::string type;
    Qos qos;               ///< as offered, or as requested if nobody writes
    bool written = true;   ///< somebody publishes it
    bool read = false;     ///< somebody other than this station subscribes to it, as robots do to commands
    std::string obstacle;  ///< why DDS cannot deliver its samples to this station; empty: it can
    /// Of its type, "RIHS01_..." (REP 2016), as its publisher tells; empty: unknown, as before Iron.
    std::string typeHash = {};
    /// Full names of the ROS 2 nodes that publish the topic, or that read it if nobody publishes:
    /// "/kurt3d/driver". Empty: unknown.
    std::vector<std::string> nodes = {};
    /// How large the robot is by its model, if one is published there; null: none, or not known yet.
    std::shared_ptr<const Result<BodyExtent>> model = {};
};

}  // namespace leitstand
