#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "tests/support/dds/test_domain.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// What the log of a station has of one stream, beside what its robot sent meanwhile.
struct Kept {
    std::string topic, robot;
    bool reliable = false;
    std::uint64_t sent = 0;    ///< by the writer's numbers, from the first to the last that both heard
    std::uint64_t logged = 0;  ///< of these
};

/// Hears what robots send now and then, beside a station, and remembers the writers' numbers of what it
/// heard: between two samples that the station has logged too, it has to have logged as many as were
/// numbered. It sees losses on the way, in the station and before the disk alike.
class Witness {
public:
    Witness(const TestDomain& domain, const std::vector<RobotDescription>& robots);

    /// Listens for a while: until it has heard some of each steady stream. False when that takes too long.
    [[nodiscard]] bool listen();
    /// What @p mission, a log that is closed, has of each stream that was heard.
    [[nodiscard]] std::vector<Kept> compare(const std::filesystem::path& mission) const;

private:
    /// A sample, told by its bytes.
    struct Print {
        std::size_t bytes = 0;
        std::uint64_t sequence = 0;  ///< at its writer
    };
    struct Stream {
        std::string robot;
        StreamDescription description;
        std::vector<Print> received = {};
        std::size_t before = 0;  ///< heard when it began to listen
    };

    void receive(Stream& stream, const ReceivedSample& sample);
    [[nodiscard]] bool heardSome() const;

    const TestDomain& m_domain;
    mutable std::mutex m_mutex;
    std::vector<Stream> m_streams;
};

}  // namespace leitstand::test
