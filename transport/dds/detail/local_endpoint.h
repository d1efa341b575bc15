#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "core/robot/streams/qos.h"
#include "transport/dds/guid.h"

namespace leitstand::detail {

/// What must be known about one of our readers or writers to explain why it does not match others.
struct LocalEndpoint {
    enum class Kind : std::uint8_t { Reader, Writer };
    Kind kind = Kind::Reader;
    std::string ddsTopic, ddsType;
    Qos qos;                 ///< QoS in effect, profiles included
    std::set<Guid> matched;  ///< remote endpoints with which it exchanges samples
};

}  // namespace leitstand::detail
