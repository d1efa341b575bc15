#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "core/robot/streams/qos.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/node_settings.h"

namespace leitstand::detail {

/// Returns how many samples a history with @p qos holds: the depth, or 5000 if the history keeps all (depth
/// 0).
[[nodiscard]] int historyOf(const Qos& qos);

[[nodiscard]] eprosima::fastdds::dds::DataReaderQos readerQos(const Qos& qos);
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writerQos(const Qos& qos, Flow flow);

/// Overrides settings that a user's profile must not change, since samples would be lost without notice:
/// payload buffers grow with the samples, no data sharing, XCDR1.
void keepSound(eprosima::fastdds::dds::DataReaderQos& qos);
void keepSound(eprosima::fastdds::dds::DataWriterQos& qos);

/// Returns the policies of a remote endpoint as Qos. The caller passes @p depth, since discovery does not
/// report it.
[[nodiscard]] inline Qos qosOf(const fastdds::EndpointData& data, int depth) {
    namespace efd = eprosima::fastdds::dds;
    Qos qos;
    qos.reliability = data.reliability.kind == efd::RELIABLE_RELIABILITY_QOS ? Qos::Reliability::Reliable
                                                                             : Qos::Reliability::BestEffort;
    qos.durability = data.durability.kind == efd::VOLATILE_DURABILITY_QOS ? Qos::Durability::Volatile
                                                                          : Qos::Durability::TransientLocal;
    qos.depth = depth;
    qos.lifespan = fastdds::secondsOf(data.lifespan.duration);
    qos.deadline = fastdds::secondsOf(data.deadline.period);
    return qos;
}

}  // namespace leitstand::detail
