#include "transport/dds/detail/writer.h"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "transport/cdr/encapsulation.h"
#include "transport/dds/detail/convert.h"
#include "transport/dds/detail/participant.h"
#include "transport/dds/detail/raw_type.h"

namespace leitstand::detail {
namespace {

namespace efd = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::chrono::milliseconds Slice{
    50};  // what close() waits for somebody who waits for acknowledgments

}  // namespace

Writer::Writer(Participant& participant, WriterSettings settings)
    : m_participant(participant), m_settings(std::move(settings)) {}

Writer::~Writer() = default;

Result<void> Writer::open() {
    auto made = m_participant.createWriter(m_settings, *this);
    if (!made) return made.error();
    m_writer = *made;
    m_guid = guidOf(m_writer->guid());
    return {};
}

void Writer::close() {
    const std::unique_lock lock(m_use);
    if (m_writer != nullptr) m_participant.deleteWriter(*this, m_writer);
    m_writer = nullptr;
}

Result<void> Writer::write(const Payload& cdr) {
    if (!cdr || cdr->size() < EncapsulationSize) {
        return Error{fmt::format("{}: a sample begins with {} bytes of encapsulation", m_settings.topic,
                                 EncapsulationSize)};
    }
    const std::shared_lock lock(m_use);
    if (m_writer == nullptr) return Error{m_settings.topic + ": the node has left its domain"};
    RawSample sample{cdr};
    if (!m_writer->write(&sample))
        return Error{m_settings.topic + ": the history is full, nobody acknowledges"};
    return {};
}

int Writer::matched() const {
    const std::shared_lock lock(m_use);
    if (m_writer == nullptr) return 0;
    efd::PublicationMatchedStatus status;
    m_writer->get_publication_matched_status(status);
    return status.current_count;
}

bool Writer::waitForAcknowledgments(std::chrono::milliseconds atMost) const {
    const auto end = std::chrono::steady_clock::now() + atMost;
    do {
        const std::shared_lock lock(m_use);
        if (m_writer == nullptr) return false;
        const auto left =
            std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        const auto wait = std::clamp(left, std::chrono::milliseconds(0), Slice);
        const eprosima::fastrtps::Duration_t slice(0, static_cast<uint32_t>(wait.count()) * 1'000'000U);
        if (m_writer->wait_for_acknowledgments(slice) == ReturnCode_t::RETCODE_OK) return true;
    } while (std::chrono::steady_clock::now() < end);
    return false;
}

void Writer::on_publication_matched(DataWriter* writer, const efd::PublicationMatchedStatus& status) {
    m_participant.discovery().matched(guidOf(writer->guid()),
                                      guidOf(rtps::iHandle2GUID(status.last_subscription_handle)),
                                      status.current_count_change > 0);
}

}  // namespace leitstand::detail
