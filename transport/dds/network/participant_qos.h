#pragma once

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "core/base/result.h"
#include "transport/dds/node_settings.h"

namespace leitstand::detail {

/// Returns the name of @p flow's queue of asynchronous samples; empty for Immediate.
[[nodiscard]] const char* flowControllerName(Flow flow);

/// Returns whether profiles of FASTRTPS_DEFAULT_PROFILES_FILE apply.
[[nodiscard]] bool usesProfiles(const NodeSettings& settings);

/// Returns @p settings as QoS of Fast DDS: UDP over IPv4 only, socket buffers of 4 MB, @p settings' lease,
/// peers and security. Shared memory fails silently between users and containers. With profiles, the user's
/// default participant replaces our defaults, and only what the settings name explicitly is added.
[[nodiscard]] Result<eprosima::fastdds::dds::DomainParticipantQos> participantQos(
    const NodeSettings& settings);

}  // namespace leitstand::detail
