#pragma once

#include <string>

#include "core/base/time.h"

namespace leitstand {

/// Where and when a sample was taken.
struct SampleHeader {
    Time stamp{};       ///< when it was taken, sender's clock; epoch: the sender does not say
    std::string frame;  ///< "kurt3d/base_link" (docs/design.md, "Conventions"); may be empty
};

}  // namespace leitstand
