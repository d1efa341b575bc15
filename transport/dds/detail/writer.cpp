#include "transport/dds/detail/writer.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "transport/cdr/encapsulation.h"
#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/endpoint_qos.h"
#include "transport/dds/detail/participant.h"
#include "transport/dds/detail/raw_type.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = fastdds::rtps;

constexpr std::chrono::milliseconds Slice{
    50};  // longest time that close() waits for waitForAcknowledgments()

}  // namespace

Writer::Writer(Participant& participant, WriterSettings settings)
    : m_participant(participant), m_settings(std::move(settings)) {}

Writer::~Writer() = default;

Result<void> Writer::open() {
    const std::unique_lock lock(m_use);
    if (m_closed || m_writer != nullptr) return {};
    auto made = m_participant.createWriter(m_settings, *this);
    if (!made) return made.error();
    m_writer = *made;
    if (m_writer == nullptr) return {};  // the participant opens it when it is back in its domain
    m_guid = guidOf(m_writer->guid());
    const std::scoped_lock keptLock(m_keptMutex);
    for (const Payload& cdr : m_kept) {
        if (auto sent = send(cdr); !sent) return sent;
    }
    return {};
}

void Writer::suspend() {
    const std::unique_lock lock(m_use);
    if (m_writer != nullptr) m_participant.deleteWriter(*this, m_writer);
    m_writer = nullptr;
}

void Writer::close() {
    {
        const std::unique_lock lock(m_use);
        m_closed = true;
    }
    suspend();
}

bool Writer::isKept() const {
    return m_settings.qos.durability == Qos::Durability::TransientLocal;
}

Result<void> Writer::send(const Payload& cdr) {
    RawSample sample{cdr};
    if (!fastdds::write(*m_writer, &sample))
        return Error{m_settings.topic + ": the history is full, nobody acknowledges"};
    return {};
}

Result<void> Writer::check(const Payload& cdr) const {
    if (cdr && cdr->size() >= EncapsulationSize) return {};
    return Error{fmt::format("{}: a sample begins with {} bytes of encapsulation", m_settings.topic,
                             EncapsulationSize)};
}

Result<std::uint64_t> Writer::write(const Payload& cdr, const SampleIdentity& related) {
    if (auto checked = check(cdr); !checked) return checked.error();
    const std::shared_lock lock(m_use);
    if (m_writer == nullptr) return Error{m_settings.topic + ": the node is outside its domain"};
    RawSample sample{cdr};
    rtps::WriteParams parameters;
    parameters.related_sample_identity(fromIdentity(related));
    if (!fastdds::write(*m_writer, &sample, parameters))
        return Error{m_settings.topic + ": the history is full, nobody acknowledges"};
    return numberOf(parameters.sample_identity().sequence_number());
}

Result<void> Writer::write(const Payload& cdr) {
    if (auto checked = check(cdr); !checked) return checked;
    const std::shared_lock lock(m_use);
    if (m_closed) return Error{m_settings.topic + ": the node has left its domain"};
    if (isKept()) {
        const std::scoped_lock keptLock(m_keptMutex);
        m_kept.push_back(cdr);
        if (m_kept.size() > static_cast<std::size_t>(historyOf(m_settings.qos))) m_kept.pop_front();
    }
    return m_writer == nullptr ? Result<void>{} : send(cdr);
}

Guid Writer::guid() const {
    const std::shared_lock lock(m_use);
    return m_guid;
}

int Writer::matched() const {
    const std::shared_lock lock(m_use);
    if (m_writer == nullptr) return 0;
    efd::PublicationMatchedStatus status;
    m_writer->get_publication_matched_status(status);
    return status.current_count;
}

std::vector<Guid> Writer::readers() const {
    return m_participant.discovery().matchedWith(guid());
}

bool Writer::waitForAcknowledgments(std::chrono::milliseconds atMost) const {
    const auto end = std::chrono::steady_clock::now() + atMost;
    do {
        const std::shared_lock lock(m_use);
        if (m_writer == nullptr) return false;
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        const auto wait = std::clamp(left, std::chrono::milliseconds(0), Slice);
        const fastdds::Duration slice(0, static_cast<uint32_t>(wait.count()) * 1'000'000U);
        if (fastdds::succeeded(m_writer->wait_for_acknowledgments(slice))) return true;
    } while (std::chrono::steady_clock::now() < end);
    return false;
}

void Writer::on_publication_matched(DataWriter* writer, const efd::PublicationMatchedStatus& status) {
    m_participant.discovery().matched(guidOf(writer->guid()),
                                      guidOf(rtps::iHandle2GUID(status.last_subscription_handle)),
                                      status.current_count_change > 0);
}

}  // namespace leitstand::detail
