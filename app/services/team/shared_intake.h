#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/services/log/event_sink.h"
#include "core/base/time.h"
#include "core/event/raw_event.h"
#include "core/event/sample.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

struct ClockSample;
struct FindSample;
struct KeyScanSample;
struct ScanBodiesSample;
struct ScanLinksSample;
struct Event;

/// What a SharedIntake needs. Its functions may be called on any thread, while the intake's lock is held.
struct SharedIntakeSetup {
    Sender me;            ///< this process, when it starts; of its own samples only grants are taken
    std::string station;  ///< the station's persistent identity
    std::function<MissionStatePtr()> mission = {};  ///< its result is never null
    std::function<bool()> holdsMap = {};            ///< returns whether this station makes the map
    std::function<void(RawEvent)> enter = {};  ///< adds an event to the log; the order of the calls is kept
    std::function<void(const std::string&)> notify = {};  ///< called with a text for the operator
    /// Called when it is found that another station makes this mission's map.
    std::function<void()> onJoined = {};
    /// Called when a find of this station needs another number, because a find of another station had its
    /// number first.
    std::function<void(const FindSample&)> fileAgain = {};
};

/// Passes what other stations publish about the mission to this station's log (docs/stations.md). Samples on
/// different topics may arrive in any order, and a station that joins later receives everything again. The
/// log gets each entry once, and after the entries on which it is based:
///
/// - A key scan that the map already has is left out. A different key scan with the same number replaces the
///   known one, since its station was killed and lost that one. Poses and places wait until all their
///   scans have arrived.
/// - Of samples about the same find, candidate, clock or mission description, the one with the newest stamp
/// is
///   valid. If two finds have the same number, the one that was found first keeps it. A clock that a
///   station started automatically is replaced by any other.
/// - A station that makes the map takes no other station's map. It may be wrong for a moment: after a restart
///   it makes the map as before, until it receives that another station now does. It keeps what it receives
///   of a map in this time for UntilDecided. If another station does make the map, what that station
///   published is taken.
/// - If this mission has scans and the map of another station shares none of them, that is a different map.
///   This is reported once, and nothing that is in that map is taken. (A station that meets another one
///   publishes all its scans to it, from the first on.)
///
/// Any thread.
class SharedIntake : public EventSink {
public:
    explicit SharedIntake(SharedIntakeSetup setup);

    /// From now on, @p me is the identity of this process in the domain.
    void rejoined(const Sender& me);
    /// Takes @p event, which @p from published on one of station_topic.
    void take(RawEvent event, const Sender& from, SteadyTime now);
    /// Takes an event of this station's log: its key scans and links are known from then on.
    void onEvent(const Event& event) override;
    /// Whether this station's finds are in the map that others know: it makes the map, has none, or shares
    /// theirs.
    [[nodiscard]] bool sharesMap() const;
    /// Whether the key scan @p id came from another station in this session.
    [[nodiscard]] bool isAdopted(std::uint64_t id) const;

    static constexpr std::chrono::seconds LongestWait{60};  ///< how long poses wait for their scans
    /// How long it is unknown who makes the map; heartbeats are sent every second.
    static constexpr std::chrono::seconds UntilDecided{10};
    static constexpr std::size_t MostUndecidedBytes = std::size_t{256} << 20U;
    static constexpr std::size_t MostWaiting = 4096;  ///< largest number of waiting samples per station
    /// Largest number of waiting key scans per station, with all their points.
    static constexpr std::size_t MostWaitingScans = 64;

private:
    /// Distinguishes a key scan from another one with the same number.
    struct Known {
        std::string robot;
        Time entered{};
        friend bool operator==(const Known&, const Known&) = default;
    };
    struct Waiting {
        RawEvent event;
        SteadyTime since;
        std::vector<std::uint64_t> scans;  ///< ids of the scans on which it is based
        /// If it is a key scan: its id, and how to recognise it.
        std::optional<std::pair<std::uint64_t, Known>> scan = {};
    };
    /// What others published about a map while this station made it.
    struct Undecided {
        RawEvent event;
        Sender from;
        SteadyTime since;
    };
    enum class Map : std::uint8_t { Unknown, Same, Other };
    struct Other {
        Map map = Map::Unknown;
        std::deque<Waiting> waiting;  ///< samples that belong to its map, in order of arrival
    };
    [[nodiscard]] bool wants(const Event& event, Other& other);
    [[nodiscard]] bool wants(const KeyScanSample& scan, Other& other);
    [[nodiscard]] bool wants(const ScanLinksSample& sample) const;
    [[nodiscard]] bool wants(const ScanBodiesSample& sample) const;
    [[nodiscard]] bool wants(const FindSample& find);
    [[nodiscard]] bool wants(const ClockSample& clock) const;
    [[nodiscard]] bool waits(const Sample& sample, const Sender& from, const Other& other) const;
    void receive(RawEvent event, const Sender& from, SteadyTime now);
    void receiveGrant(const RawEvent& event, const Sender& from, SteadyTime now);
    void keepUndecided(RawEvent event, const Sender& from, SteadyTime now);
    /// If another station makes the map, takes the undecided samples: those of that station, when it is
    /// known.
    void decide(SteadyTime now);
    void publishOtherMap(std::uint64_t scan) const;
    [[nodiscard]] bool knows(const std::vector<std::uint64_t>& scans) const;
    static void wait(Waiting one, Other& other);
    void enterLate(Waiting one, Other& other);  ///< enters it if it is needed by now
    void enter(RawEvent event, Sample sample);
    /// Releases scans of this map before everything else that waits: poses that arrived before their scan
    /// wait for it and must not delay it.
    void releaseScans(Other& other);
    void release(SteadyTime now);

    const SharedIntakeSetup m_setup;
    mutable std::mutex m_mutex;
    Sender m_me;                             ///< under the mutex
    std::map<std::uint64_t, Known> m_scans;  ///< by id; under the mutex, like all members below
    std::set<std::uint64_t> m_adopted;
    std::map<std::uint64_t, bool> m_links;  ///< whether links of scans are active, by id of the link
    std::map<Sender, Other> m_others;
    std::deque<Undecided> m_undecided;  ///< in order of arrival
    std::size_t m_undecidedBytes = 0;
    std::optional<Sender> m_maker;  ///< station that makes the map, according to its own reports
    SteadyTime m_makerReceived{};   ///< when it last reported this
};

}  // namespace leitstand
