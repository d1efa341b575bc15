#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "core/robot/streams/qos.h"
#include "transport/dds/guid.h"

namespace leitstand::detail {

/// What discovery must know about one of our own readers or writers to explain why it does not match others.
struct LocalEndpoint {
    enum class Kind : std::uint8_t { Reader, Writer };
    Kind kind = Kind::Reader;
    std::string ddsTopic, ddsType;
    Qos qos;                 ///< in effect, profiles included
    std::set<Guid> matched;  ///< remote endpoints it exchanges samples with
};

}  // namespace leitstand::detail
