#pragma once

#include <memory>
#include <string>
#include <vector>

#include <fastdds/dds/domain/qos/DomainParticipantQos.hpp>

#include "transport/dds/node_settings.h"
#include "transport/screen/screen.h"

namespace leitstand::detail {

/// The screen of a node with @p settings.
[[nodiscard]] std::shared_ptr<screen::Screen> screenFor(const NodeSettings& settings);

/// Puts @p screen before every transport of @p qos that takes datagrams, those of the library's own choice
/// and of XML profiles too. Returns what cannot be screened, in words for the operator.
[[nodiscard]] std::vector<std::string> putBefore(eprosima::fastdds::dds::DomainParticipantQos& qos,
                                                 std::shared_ptr<screen::Screen> screen);

}  // namespace leitstand::detail
