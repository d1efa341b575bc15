#include "transport/dds/detail/endpoint_qos.h"

#include <algorithm>

#include "transport/dds/network/participant_qos.h"

namespace leitstand::detail {

int historyOf(const Qos& qos) {
    constexpr int MostKept = 5000;
    return qos.depth > 0 ? qos.depth : MostKept;
}

namespace {

namespace efd = eprosima::fastdds::dds;
using Duration_t = fastdds::Duration;

constexpr double Heartbeats = 0.1;  ///< period for reliable writers while a reader lacks samples [s]
// A reliable Fast DDS reader that may keep only one sample is stuck after a loss. The newer sample waits
// until the lost one is given up, and the next has no room. Over a link with 5 % loss, one of two is lost
// then.
constexpr int LeastKeptByReaders = 16;
// Samples wait in their writer's history for the sending thread. With room for ten, a stream of 50 Hz loses
// some as soon as that thread does not run for 0.2 s.
constexpr int LeastWaiting = 100;  // small samples

/// Sets the policies that readers and writers have in common.
template <class EndpointQos>
void apply(const Qos& qos, EndpointQos& to) {
    to.reliability().kind = qos.reliability == Qos::Reliability::Reliable ? efd::RELIABLE_RELIABILITY_QOS
                                                                          : efd::BEST_EFFORT_RELIABILITY_QOS;
    to.reliability().max_blocking_time = Duration_t(0.1);
    to.durability().kind = qos.durability == Qos::Durability::TransientLocal
                               ? efd::TRANSIENT_LOCAL_DURABILITY_QOS
                               : efd::VOLATILE_DURABILITY_QOS;
    const bool all = qos.depth <= 0;
    to.history().kind = all ? efd::KEEP_ALL_HISTORY_QOS : efd::KEEP_LAST_HISTORY_QOS;
    to.history().depth = std::max(qos.depth, 1);
    auto& limits = to.resource_limits();
    limits.max_samples = limits.max_samples_per_instance = historyOf(qos);
    limits.max_instances = 1;
    limits.allocated_samples = std::min(limits.max_samples, 8);
    if (qos.deadline > 0.0) to.deadline().period = Duration_t(static_cast<long double>(qos.deadline));
}

template <class EndpointQos>
void makeSound(EndpointQos& qos) {
    qos.endpoint().history_memory_policy =
        fastdds::rtps::MemoryManagementPolicy_t::PREALLOCATED_WITH_REALLOC_MEMORY_MODE;
    qos.data_sharing().off();
}

}  // namespace

void keepSound(efd::DataReaderQos& qos) {
    makeSound(qos);
    fastdds::representationOf(qos).m_value = {efd::XCDR_DATA_REPRESENTATION};
}

void keepSound(efd::DataWriterQos& qos) {
    makeSound(qos);
    qos.representation().m_value = {efd::XCDR_DATA_REPRESENTATION};
}

efd::DataReaderQos readerQos(const Qos& qos) {
    efd::DataReaderQos made;
    Qos roomy = qos;
    if (qos.depth > 0) roomy.depth = std::max(qos.depth, LeastKeptByReaders);
    apply(roomy, made);
    // A reader's own lifespan would count by the writer's clock: with one second between the clocks, all is
    // lost.
    keepSound(made);
    return made;
}

efd::DataWriterQos writerQos(const Qos& qos, Flow flow) {
    efd::DataWriterQos made;
    Qos roomy = qos;
    if (flow == Flow::Telemetry && qos.depth > 0 && qos.reliability == Qos::Reliability::BestEffort)
        roomy.depth = std::max(qos.depth, LeastWaiting);
    apply(roomy, made);
    fastdds::countWhatIsSent(made);
    if (qos.lifespan > 0.0) made.lifespan().duration = Duration_t(static_cast<long double>(qos.lifespan));
    // Samples with a short lifespan are requested again soon: a lost drive command can still arrive in time.
    const double period = qos.lifespan > 0.0 ? std::min(Heartbeats, qos.lifespan / 10.0) : Heartbeats;
    fastdds::setHeartbeat(made, Duration_t(static_cast<long double>(period)));
    if (flow == Flow::Immediate) {
        made.publish_mode().kind = efd::SYNCHRONOUS_PUBLISH_MODE;
    } else {
        made.publish_mode().kind = efd::ASYNCHRONOUS_PUBLISH_MODE;
        if constexpr (fastdds::HasFlowControllers)
            made.publish_mode().flow_controller_name = flowControllerName(flow);
    }
    keepSound(made);
    return made;
}

}  // namespace leitstand::detail
