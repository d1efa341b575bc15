#pragma once

#include <fastdds/dds/publisher/qos/DataWriterQos.hpp>
#include <fastdds/dds/subscriber/qos/DataReaderQos.hpp>

#include "core/robot/qos.h"
#include "transport/dds/node_settings.h"

namespace leitstand::detail {

[[nodiscard]] eprosima::fastdds::dds::DataReaderQos readerQos(const Qos& qos);
[[nodiscard]] eprosima::fastdds::dds::DataWriterQos writerQos(const Qos& qos, Flow flow);

/// Sets what must hold whatever a profile says, or samples are lost without a word: histories that grow with
/// the samples, no data sharing, XCDR1.
void keepSound(eprosima::fastdds::dds::DataReaderQos& qos);
void keepSound(eprosima::fastdds::dds::DataWriterQos& qos);

/// What Fast DDS policies say in our terms; @p depth is told by the caller, since discovery does not tell it.
template <class Policies>
[[nodiscard]] Qos qosOf(const Policies& policies, int depth) {
    namespace efd = eprosima::fastdds::dds;
    Qos qos;
    const auto seconds = [](const eprosima::fastrtps::Duration_t& d) {
        return d == eprosima::fastrtps::c_TimeInfinite ? 0.0 : static_cast<double>(d.to_ns()) * 1e-9;
    };
    qos.reliability = policies.m_reliability.kind == efd::RELIABLE_RELIABILITY_QOS
                          ? Qos::Reliability::Reliable
                          : Qos::Reliability::BestEffort;
    qos.durability = policies.m_durability.kind == efd::VOLATILE_DURABILITY_QOS
                         ? Qos::Durability::Volatile
                         : Qos::Durability::TransientLocal;
    qos.depth = depth;
    qos.lifespan = seconds(policies.m_lifespan.duration);
    qos.deadline = seconds(policies.m_deadline.period);
    return qos;
}

}  // namespace leitstand::detail
