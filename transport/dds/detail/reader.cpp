#include "transport/dds/detail/reader.h"

#include <algorithm>
#include <chrono>

#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/participant.h"
#include "transport/dds/detail/raw_type.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = fastdds::rtps;

}  // namespace

Reader::Reader(Participant& participant, ReaderSettings settings, SampleCallback callback)
    : m_participant(participant), m_settings(std::move(settings)), m_callback(std::move(callback)) {}

Reader::~Reader() = default;

Result<void> Reader::open() {
    const std::scoped_lock lock(m_use);
    if (m_closed || m_reader != nullptr) return {};
    auto made = m_participant.createReader(m_settings, *this);
    if (!made) return made.error();
    m_reader = *made;
    if (m_reader == nullptr) return {};  // the participant opens it when it is back in its domain
    {
        const std::scoped_lock countsLock(m_countsMutex);
        m_guid = guidOf(m_reader->guid());
    }
    m_condition = &m_reader->get_statuscondition();
    m_condition->set_enabled_statuses(efd::StatusMask::data_available());
    m_participant.deliver(shared_from_this());
    return {};
}

void Reader::close() {
    m_closed = true;
    suspend();
}

void Reader::suspend() {
    const std::scoped_lock lock(m_use);
    if (m_reader != nullptr) m_participant.deleteReader(*this, m_reader);
    m_reader = nullptr;
    const std::scoped_lock countsLock(m_countsMutex);
    m_counts.writers = 0;
}

bool Reader::take(ReceivedSample& sample) {
    RawSample raw;
    efd::SampleInfo info;
    while (fastdds::succeeded(m_reader->take_next_sample(&raw, &info))) {
        if (!info.valid_data || !raw.cdr) continue;
        sample.event.topic = m_settings.topic;
        sample.event.type = m_settings.type;
        // Fast DDS's own reception time is that of the first piece of a sample: a slice may take seconds
        // more.
        sample.event.received = std::chrono::system_clock::now();
        sample.event.cdr = std::move(raw.cdr);
        sample.writer = guidOf(info.sample_identity.writer_guid());
        sample.sourceTime = timeOf(info.source_timestamp);
        sample.writerSequence = numberOf(info.sample_identity.sequence_number());
        sample.related = relatedOf(info.related_sample_identity);
        return true;
    }
    return false;
}

void Reader::count(const ReceivedSample& sample) {
    const std::scoped_lock lock(m_countsMutex);
    ++m_counts.samples;
    m_counts.bytes += sample.event.cdr->size();
    std::uint64_t& last = m_lastNumbers[sample.writer];
    if (last != 0 && sample.writerSequence > last + 1) m_counts.lost += sample.writerSequence - last - 1;
    last = std::max(last, sample.writerSequence);
}

bool Reader::deliver() {
    if (m_closed) return false;  // before the lock: close() must not wait for one sample after the other
    const std::scoped_lock lock(m_use);
    ReceivedSample sample;
    if (m_closed || m_reader == nullptr || !take(sample)) return false;
    count(sample);
    m_callback(std::move(sample));
    return true;
}

bool Reader::hasReceived(const Guid& writer) const {
    const std::scoped_lock lock(m_countsMutex);
    return m_lastNumbers.contains(writer);
}

Guid Reader::guid() const {
    const std::scoped_lock lock(m_countsMutex);
    return m_guid;
}

SubscriptionCounts Reader::counts() const {
    const std::scoped_lock lock(m_countsMutex);
    return m_counts;
}

void Reader::on_subscription_matched(DataReader* reader, const efd::SubscriptionMatchedStatus& status) {
    const Guid writer = guidOf(rtps::iHandle2GUID(status.last_publication_handle));
    const bool now = status.current_count_change > 0;
    {
        const std::scoped_lock lock(m_countsMutex);
        m_counts.writers = status.current_count;
        if (!now) m_lastNumbers.erase(writer);
    }
    m_participant.discovery().matched(guidOf(reader->guid()), writer, now);
}

}  // namespace leitstand::detail
