#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "tests/app/recording.h"
#include "tests/app/robots/listening_station.h"
#include "tests/app/station/station_scene.h"
#include "tests/transport/screen_wire/mutations.h"

namespace leitstand::test {

/// Both robots, a recorder, a station and the session of another one in a domain on loopback, with keys or
/// without, and what is needed to attack them.
class Besieged : public StationScene {
protected:
    enum class Keys : std::uint8_t { None, All };
    void begin(Keys keys);

    /// Traffic of the domain, as a further participant hears it.
    [[nodiscard]] std::vector<RecordedPacket> overheard(std::size_t packets);
    /// Announces @p participants, each with @p topics of its own, from as many ports.
    void crowd(int participants, int topics);
    /// Sends @p count packets of @p how, made of @p recorded.
    void storm(Mutator& mutator, Mutation how, int count);

    /// All live and are as small as before, stations and recorder hear both robots as before within 5 s of
    /// now. Prints a line that packaging/attack-table.py gathers.
    void expectUnharmed(const std::string& what, std::uint64_t packets);
    /// Ends the recorder: all is there, and its log is whole.
    void endAndExpectWhole();

private:
    /// A process, and what it had in memory before the attacks.
    struct Watched {
        std::string who;
        pid_t process;
        double megabytes;
    };
    struct Proof {
        std::string what;
        Time end;  ///< of the attack
    };
    [[nodiscard]] std::vector<std::string> with(std::vector<std::string> arguments,
                                                const std::string& enclave) const;
    [[nodiscard]] std::vector<std::string> robotArguments(const std::string& kind) const;
    [[nodiscard]] bool hearsAgain();
    /// What @p robot said from @p from for a second, by the numbers of its writer; 0 while that is unknown.
    [[nodiscard]] std::uint64_t saidFrom(const std::string& robot, Time from) const;
    void listen(const std::string& robot);
    [[nodiscard]] std::string drops() const;
    void watch(const std::string& who, pid_t process);

    Keys m_keys = Keys::None;
    std::vector<std::unique_ptr<ChildProcess>> m_robots;
    std::unique_ptr<ChildProcess> m_recorder;
    std::unique_ptr<ListeningStation> m_other;  ///< the station that is a process of its own
    std::vector<Watched> m_watched;             ///< all processes
    std::unique_ptr<Node> m_node;               ///< hears both robots for itself
    std::map<std::string, Inbox> m_inboxes;     ///< odometry, of the node
    std::vector<std::unique_ptr<Subscription>> m_listening;
    mutable std::mutex m_heardMutex;
    std::map<std::string, std::vector<Time>> m_received;  ///< odometry, by the station
    std::vector<Proof> m_proofs;
    std::unique_ptr<Attacker> m_attacker;
    std::unique_ptr<Station> m_station;  ///< last: its callbacks use the others
};

}  // namespace leitstand::test
