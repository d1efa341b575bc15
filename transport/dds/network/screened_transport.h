#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "transport/dds/node_settings.h"
#include "transport/screen/screen.h"

namespace leitstand::detail {

/// Creates the screen of a node with @p settings; @p dropped as in Screen.
[[nodiscard]] std::shared_ptr<screen::Screen> screenFor(const NodeSettings& settings,
                                                        std::function<void()> dropped = {});

/// Puts @p screen before every transport of @p qos that takes datagrams, also those of the library's own
/// choice and of XML profiles. Returns what cannot be screened, in words for the operator.
[[nodiscard]] std::vector<std::string> putBefore(eprosima::fastdds::dds::DomainParticipantQos& qos,
                                                 std::shared_ptr<screen::Screen> screen);

/// Puts @p screen before one transport.
[[nodiscard]] std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> screened(
    std::shared_ptr<eprosima::fastdds::rtps::TransportDescriptorInterface> transport,
    std::shared_ptr<screen::Screen> screen);

}  // namespace leitstand::detail
