#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>

#include <fastdds/dds/core/condition/StatusCondition.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>

#include "transport/dds/node.h"

namespace leitstand::detail {

class Participant;

/// A Fast DDS reader of bytes and its callback. The object exists as long as its subscription or a lane uses
/// it. The Fast DDS reader exists only until close().
class Reader final : public std::enable_shared_from_this<Reader>,
                     private eprosima::fastdds::dds::DataReaderListener {
public:
    Reader(Participant& participant, ReaderSettings settings, SampleCallback callback);
    ~Reader() override;

    /// Creates the Fast DDS reader and adds this object to its lane. Does nothing when the Fast DDS reader
    /// exists, after close(), or while the participant is outside its domain.
    Result<void> open();
    /// Leaves the topic until the next open(), because the participant leaves its domain. Waits as close()
    /// does.
    void suspend();
    /// Leaves the topic permanently. Waits for a callback that runs on another thread; the callback itself
    /// may call this.
    void close();
    /// Calls the callback with one sample. Returns false when there is none. Runs on a lane's thread.
    [[nodiscard]] bool deliver();

    [[nodiscard]] SubscriptionCounts counts() const;
    [[nodiscard]] Guid guid() const;  ///< of the newest Fast DDS reader
    /// Whether a sample was received from @p writer since it matched.
    [[nodiscard]] bool hasReceived(const Guid& writer) const;
    [[nodiscard]] const ReaderSettings& settings() const { return m_settings; }
    /// Valid only while open.
    [[nodiscard]] eprosima::fastdds::dds::StatusCondition& condition() const { return *m_condition; }
    [[nodiscard]] const eprosima::fastdds::dds::Condition* conditionAddress() const { return m_condition; }

    bool unfinished = false;  ///< set by the lane: samples were left

private:
    using DataReader = eprosima::fastdds::dds::DataReader;
    void on_subscription_matched(DataReader* reader,
                                 const eprosima::fastdds::dds::SubscriptionMatchedStatus& status) override;
    [[nodiscard]] bool take(ReceivedSample& sample);
    void count(const ReceivedSample& sample);

    Participant& m_participant;
    const ReaderSettings m_settings;
    const SampleCallback m_callback;
    std::recursive_mutex m_use;  // held while the reader is used and calls back
    std::atomic<bool> m_closed = false;
    DataReader* m_reader = nullptr;
    eprosima::fastdds::dds::StatusCondition* m_condition = nullptr;
    mutable std::mutex m_countsMutex;
    SubscriptionCounts m_counts;
    Guid m_guid;
    std::map<Guid, std::uint64_t> m_lastNumbers;  // of each writer
};

}  // namespace leitstand::detail
