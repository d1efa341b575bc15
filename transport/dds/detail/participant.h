#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "transport/dds/detail/discovery.h"
#include "transport/dds/detail/lane_thread.h"
#include "transport/dds/detail/reader.h"
#include "transport/dds/detail/writer.h"
#include "transport/screen/screen.h"

namespace leitstand::detail {

/// A Fast DDS participant, its two lanes, and all readers and writers that it created. The node, its
/// subscriptions and its publishers share this object. leave() ends the Fast DDS part even if others still
/// hold the object.
class Participant {
public:
    explicit Participant(const NodeSettings& settings);
    ~Participant();
    Participant(const Participant&) = delete;
    Participant& operator=(const Participant&) = delete;

    Result<void> join();
    /// See Node::rejoin().
    Result<void> rejoin(const std::function<void(const Guid&)>& entered);
    void leave();

    Result<std::shared_ptr<Reader>> subscribe(const ReaderSettings& settings, SampleCallback callback);
    Result<std::shared_ptr<Writer>> publish(const WriterSettings& settings);
    void release(const std::shared_ptr<Reader>& reader);
    void release(const std::shared_ptr<Writer>& writer);

    [[nodiscard]] Discovery& discovery() { return m_discovery; }
    [[nodiscard]] Guid guid() const;
    [[nodiscard]] DomainReception reception() const;
    [[nodiscard]] const screen::Screen& gate() const { return *m_screen; }
    [[nodiscard]] const std::vector<std::string>& unscreened() const { return m_unscreened; }
    void onDiscovery(std::function<void()> changed);

    // For Reader and Writer. createReader() and createWriter() return null while rejoin() is out of the
    // domain.
    void deliver(const std::shared_ptr<Reader>& reader);  ///< delivers the samples of @p reader from now on
    Result<eprosima::fastdds::dds::DataReader*> createReader(
        const ReaderSettings& settings, eprosima::fastdds::dds::DataReaderListener& listener);
    void deleteReader(const Reader& reader, eprosima::fastdds::dds::DataReader* what);
    Result<eprosima::fastdds::dds::DataWriter*> createWriter(
        const WriterSettings& settings, eprosima::fastdds::dds::DataWriterListener& listener);
    void deleteWriter(const Writer& writer, eprosima::fastdds::dds::DataWriter* what);

private:
    struct UsedTopic {
        eprosima::fastdds::dds::Topic* topic = nullptr;
        int users = 0;
    };
    Result<void> enter();  // under the mutex
    Result<eprosima::fastdds::dds::Topic*> acquireTopic(const std::string& rosTopic,
                                                        const std::string& rosType);
    void releaseTopic(const std::string& ddsTopic);
    [[nodiscard]] LaneThread& laneOf(const Reader& reader);
    void notifyDiscovery();

    const NodeSettings m_settings;
    const std::shared_ptr<screen::Screen> m_screen;
    std::vector<std::string> m_unscreened;  // set by enter()
    std::shared_ptr<eprosima::fastdds::dds::DomainParticipantFactory> m_factory;
    std::mutex m_rejoining;      // held by rejoin() and leave()
    mutable std::mutex m_mutex;  // guards what follows; taken after a reader's m_use, never before
    bool m_left = false;
    bool m_away = false;                        // between leaving and joining again: nothing is created
    std::map<std::string, UsedTopic> m_topics;  // by DDS name
    std::vector<std::shared_ptr<Reader>> m_readers;
    std::vector<std::shared_ptr<Writer>> m_writers;
    std::recursive_mutex m_notifyMutex;  // held while m_notify runs
    std::function<void()> m_notify;
    Guid m_guid;
    Discovery m_discovery;
    std::unique_ptr<LaneThread> m_small, m_large;
    eprosima::fastdds::dds::DomainParticipant* m_participant = nullptr;
    eprosima::fastdds::dds::Publisher* m_publisher = nullptr;
    eprosima::fastdds::dds::Subscriber* m_subscriber = nullptr;
};

}  // namespace leitstand::detail
