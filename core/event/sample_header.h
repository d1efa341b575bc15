#pragma once

#include <string>

#include "core/base/time.h"

namespace leitstand {

/// Where and when a sample was taken.
struct SampleHeader {
    Time stamp{};       ///< sender's clock; epoch when the sender gives none
    std::string frame;  ///< "kurt3d/base_link" (docs/design.md, "Conventions"); may be empty
};

}  // namespace leitstand
