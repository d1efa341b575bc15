#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>

#include "core/robot/streams/qos.h"
#include "transport/dds/node_settings.h"
#include "transport/screen/screen.h"

namespace leitstand::test {

/// A datagram as it came from the network.
struct RecordedPacket {
    std::vector<std::byte> bytes;
    screen::Place place;
};

/// A participant as a node makes it, with the screen in the middle: what comes from the network, and what of
/// it reaches the library.
class RecordingParticipant {
public:
    explicit RecordingParticipant(const NodeSettings& settings, std::size_t keep = 200'000);
    ~RecordingParticipant();
    RecordingParticipant(const RecordingParticipant&) = delete;
    RecordingParticipant& operator=(const RecordingParticipant&) = delete;

    void listen(const std::string& topic, const Qos& qos, const std::string& type = "std_msgs/msg/String");
    [[nodiscard]] std::uint64_t arrived() const;  ///< datagrams
    [[nodiscard]] std::uint64_t passed() const;   ///< of them, bit for bit and in order, to the library
    [[nodiscard]] bool same() const;              ///< whether nothing else reached it
    [[nodiscard]] std::vector<RecordedPacket> packets() const;  ///< the first that arrived
    [[nodiscard]] const screen::Screen& gate() const { return *m_screen; }

    struct Tap;

private:
    std::shared_ptr<Tap> m_tap;
    std::shared_ptr<screen::Screen> m_screen;
    eprosima::fastdds::dds::DomainParticipant* m_participant = nullptr;
    eprosima::fastdds::dds::Subscriber* m_subscriber = nullptr;
};

}  // namespace leitstand::test
