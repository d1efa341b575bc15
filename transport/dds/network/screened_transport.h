#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "transport/dds/node_settings.h"
#include "transport/screen/screen.h"

namespace leitstand::detail {

/// Creates the screen for a node with @p settings. @p dropped: as in Screen.
[[nodiscard]] std::shared_ptr<screen::Screen> screenFor(const NodeSettings& settings,
                                                        std::function<void()> dropped = {});

/// Puts @p screen in front of every UDP transport of @p qos, including the built-in one and those of XML
/// profiles. Returns a warning for the operator for each transport that cannot be screened: shared memory,
/// TCP.
[[nodiscard]] std::vector<std::string> putBefore(eprosima::fastdds::dds::DomainParticipantQos& qos,
                                                 std::shared_ptr<screen::Screen> screen);

/// Returns @p transport with @p screen in front of it.
[[nodiscard]] std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> screened(
    std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> transport,
    std::shared_ptr<screen::Screen> screen);

}  // namespace leitstand::detail
