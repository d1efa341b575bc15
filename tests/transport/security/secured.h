#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>

#include "transport/dds/node_settings.h"

namespace leitstand::test {

/// A plain participant of Fast DDS, as a stock robot or an intruder has it: none of our transport in between.
class Participant {
public:
    Participant(int domain, const std::optional<SecurityFiles>& files);
    ~Participant();
    Participant(const Participant&) = delete;
    Participant& operator=(const Participant&) = delete;

    /// False when its own security refused to start it.
    [[nodiscard]] bool joined() const { return m_participant != nullptr; }
    [[nodiscard]] eprosima::fastdds::dds::DomainParticipant* get() const { return m_participant; }

private:
    eprosima::fastdds::dds::DomainParticipant* m_participant = nullptr;
};

/// Writes bytes to a topic, reliable and volatile.
class Writer {
public:
    Writer(const Participant& participant, const std::string& topic);
    [[nodiscard]] bool allowed() const { return m_writer != nullptr; }
    [[nodiscard]] int matched() const;
    bool write(const std::string& bytes);

private:
    eprosima::fastdds::dds::DataWriter* m_writer = nullptr;
};

/// Counts the samples of a topic.
class Reader : private eprosima::fastdds::dds::DataReaderListener {
public:
    Reader(const Participant& participant, const std::string& topic);
    ~Reader() override;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    [[nodiscard]] bool allowed() const { return m_reader != nullptr; }
    [[nodiscard]] int samples() const { return m_samples; }
    [[nodiscard]] int matched() const;

private:
    void on_data_available(eprosima::fastdds::dds::DataReader* reader) override;
    eprosima::fastdds::dds::DataReader* m_reader = nullptr;
    std::atomic<int> m_samples = 0;
};

}  // namespace leitstand::test
