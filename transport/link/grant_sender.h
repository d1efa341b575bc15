#pragma once

#include <algorithm>

#include "core/robot/control/grants.h"
#include "transport/dds/guid.h"

namespace leitstand {

/// Returns the process to which the writer, reader or participant @p guid belongs.
[[nodiscard]] inline Sender senderOf(const Guid& guid) {
    Sender sender;
    std::copy_n(guid.bytes.begin(), sender.bytes.size(), sender.bytes.begin());
    return sender;
}

}  // namespace leitstand
