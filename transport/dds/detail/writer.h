#pragma once

#include <chrono>
#include <deque>
#include <mutex>
#include <shared_mutex>
#include <vector>

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>

#include "transport/dds/node.h"

namespace leitstand::detail {

class Participant;

/// A Fast DDS writer of bytes, which exists until close().
class Writer final : private eprosima::fastdds::dds::DataWriterListener {
public:
    Writer(Participant& participant, WriterSettings settings);
    ~Writer() override;

    Result<void> open();
    /// Leaves the topic until the next open(), because the participant leaves its domain. open() writes
    /// transient local samples again. Other samples that are written in between are lost.
    void suspend();
    void close();
    Result<void> write(const Payload& cdr);
    /// See Publisher::write().
    Result<std::uint64_t> write(const Payload& cdr, const SampleIdentity& related);
    [[nodiscard]] int matched() const;
    [[nodiscard]] std::vector<Guid> readers() const;
    [[nodiscard]] bool waitForAcknowledgments(std::chrono::milliseconds atMost) const;
    [[nodiscard]] Guid guid() const;
    [[nodiscard]] const WriterSettings& settings() const { return m_settings; }

private:
    using DataWriter = eprosima::fastdds::dds::DataWriter;
    void on_publication_matched(DataWriter* writer,
                                const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;

    [[nodiscard]] Result<void> check(const Payload& cdr) const;  // whether it is a sample
    Result<void> send(const Payload& cdr);
    [[nodiscard]] bool isKept() const;  // for readers that join later

    Participant& m_participant;
    const WriterSettings m_settings;
    mutable std::shared_mutex m_use;  // shared by users of m_writer, exclusive for close()
    DataWriter* m_writer = nullptr;
    bool m_closed = false;
    Guid m_guid;
    mutable std::mutex m_keptMutex;
    std::deque<Payload> m_kept;  // newest last, as many as the history holds
};

}  // namespace leitstand::detail
