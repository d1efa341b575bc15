#pragma once

#include <chrono>
#include <shared_mutex>

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>

#include "transport/dds/node.h"

namespace leitstand::detail {

class Participant;

/// A Fast DDS writer of bytes, until close().
class Writer final : private eprosima::fastdds::dds::DataWriterListener {
public:
    Writer(Participant& participant, WriterSettings settings);
    ~Writer() override;

    Result<void> open();
    void close();
    Result<void> write(const Payload& cdr);
    [[nodiscard]] int matched() const;
    [[nodiscard]] bool waitForAcknowledgments(std::chrono::milliseconds atMost) const;
    [[nodiscard]] Guid guid() const { return m_guid; }
    [[nodiscard]] const WriterSettings& settings() const { return m_settings; }

private:
    using DataWriter = eprosima::fastdds::dds::DataWriter;
    void on_publication_matched(DataWriter* writer,
                                const eprosima::fastdds::dds::PublicationMatchedStatus& status) override;

    Participant& m_participant;
    const WriterSettings m_settings;
    mutable std::shared_mutex m_use;  // shared by those who use m_writer, alone for close()
    DataWriter* m_writer = nullptr;
    Guid m_guid;
};

}  // namespace leitstand::detail
