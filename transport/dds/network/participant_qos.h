#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "core/base/result.h"
#include "transport/dds/node_settings.h"

namespace leitstand::detail {

/// Returns the name of the flow controller for @p flow; empty for Immediate.
[[nodiscard]] const char* flowControllerName(Flow flow);

/// Returns whether XML profiles are used: the variable FASTRTPS_DEFAULT_PROFILES_FILE (in Fast DDS 3:
/// FASTDDS_DEFAULT_PROFILES_FILE) names a file.
[[nodiscard]] bool usesProfiles(const NodeSettings& settings);

/// Returns QoS of Fast DDS for @p settings: UDP over IPv4 only, socket buffers of 4 MB, and the lease, peers
/// and security in @p settings. Shared memory is off, since it fails without notice between users and
/// containers. With profiles, the user's default participant replaces our defaults, and only what the
/// settings name explicitly is added.
[[nodiscard]] Result<eprosima::fastdds::dds::DomainParticipantQos> participantQos(
    const NodeSettings& settings);

}  // namespace leitstand::detail
