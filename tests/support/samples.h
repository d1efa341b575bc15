#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/shared_bytes.h"
#include "core/event/sample.h"
#include "core/robot/robot_description.h"

namespace leitstand::test {

/// A sample of one kind, all fields filled with different values, and how it travels.
struct SampleCase {
    std::string type;                ///< ROS name
    std::optional<StreamRole> role;  ///< empty: on a topic of the stations
    Sample sample;

    [[nodiscard]] StreamDescription stream() const;  ///< of a robot "kurt3d"; only with a role
};

/// One case for every type that can be encoded. Rotations are exact in floating point, so that samples
/// survive any number of conversions bit by bit.
[[nodiscard]] std::vector<SampleCase> sampleCases();

/// Bytes as a message brings them.
[[nodiscard]] SharedBytes sharedBytes(std::vector<std::byte> bytes);

}  // namespace leitstand::test
