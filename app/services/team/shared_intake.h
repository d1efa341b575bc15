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

/// What a SharedIntake works with. Its functions may be called on any thread, while the lock of the intake is
/// held.
struct SharedIntakeSetup {
    Sender me;            ///< this process at first; of its own samples only grants are taken
    std::string station;  ///< persistent identity
    std::function<MissionStatePtr()> mission = {};  ///< never null
    std::function<bool()> holdsMap = {};            ///< whether this station makes the map
    std::function<void(RawEvent)> enter = {};       ///< adds an event to the log, in the order of the calls
    std::function<void(const std::string&)> notify = {};  ///< for the operator, in words
    /// Called when another station turns out to make this mission's map.
    std::function<void()> onJoined = {};
    /// Called when a find of this station needs another number: a find of another station had its number
    /// first.
    std::function<void(const FindSample&)> fileAgain = {};
};

/// Passes what other stations publish of the mission on to this station's log (docs/stations.md). Samples of
/// different topics overtake each other on the wire, and a station that comes late receives everything again.
/// The log gets each entry once, and after what it builds on:
///
/// - A key scan that the map has already is left out. A different key scan with the same number replaces the
///   known one, since its station lost that one when it was killed. Poses and places wait until all their
///   scans are there.
/// - Of samples about one find, candidate, clock or mission description, the newest by its stamp counts. Of
///   two finds with one number, the one that was found first keeps the number. A clock that a station began
///   by itself gives way.
/// - A station that makes the map takes no other station's map. It may be wrong for a moment: after a restart
///   it makes the map as before, until it receives that another station does by now. It keeps what it
///   receives of a map meanwhile for UntilDecided. If another station turns out to make the map, what that
///   station published is taken.
/// - If this mission has scans and the map of another station shares none of them, that is another map. This
///   is reported once, and nothing that lies in that map is taken. (A station that meets another one
///   publishes all its scans to it, from the first on.)
///
/// Any thread.
class SharedIntake : public EventSink {
public:
    explicit SharedIntake(SharedIntakeSetup setup);

    /// Sets the identity of this process in the domain to @p me from now on.
    void rejoined(const Sender& me);
    /// Takes @p event, which @p from published on one of station_topic.
    void take(RawEvent event, const Sender& from, SteadyTime now);
    /// Takes an event of our log: key scans and their links are known from then on.
    void onEvent(const Event& event) override;
    /// Whether this station's finds lie in the map that others know: it makes the map, has none, or shares
    /// theirs.
    [[nodiscard]] bool sharesMap() const;
    /// Whether key scan @p id came from another station in this session.
    [[nodiscard]] bool isAdopted(std::uint64_t id) const;

    static constexpr std::chrono::seconds LongestWait{60};  ///< of poses for their scans
    static constexpr std::chrono::seconds UntilDecided{
        10};  ///< who makes the map: heartbeats come each second
    static constexpr std::size_t MostUndecidedBytes = std::size_t{256} << 20U;
    static constexpr std::size_t MostWaiting = 4096;     ///< of one station
    static constexpr std::size_t MostWaitingScans = 64;  ///< key scans of one station, with all their points

private:
    /// Distinguishes a key scan from another of its number.
    struct Known {
        std::string robot;
        Time entered{};
        friend bool operator==(const Known&, const Known&) = default;
    };
    struct Waiting {
        RawEvent event;
        SteadyTime since;
        std::vector<std::uint64_t> scans;                          ///< scans that it builds on
        std::optional<std::pair<std::uint64_t, Known>> scan = {};  ///< if it is a key scan: its id
    };
    /// What was published of a map while this station made it.
    struct Undecided {
        RawEvent event;
        Sender from;
        SteadyTime since;
    };
    enum class Map : std::uint8_t { Unknown, Same, Other };
    struct Other {
        Map map = Map::Unknown;
        std::deque<Waiting> waiting;  ///< what lies in its map, in order of arrival
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
    /// Takes undecided samples, if another station makes the map: those of that station, when it is known.
    void decide(SteadyTime now);
    void publishOtherMap(std::uint64_t scan) const;
    [[nodiscard]] bool knows(const std::vector<std::uint64_t>& scans) const;
    static void wait(Waiting one, Other& other);
    void enterLate(Waiting one, Other& other);  ///< if it is wanted by now
    void enter(RawEvent event, Sample sample);
    /// Releases scans of this map before all else that waits: poses that overtook a scan wait for it, and
    /// must not hold it up.
    void releaseScans(Other& other);
    void release(SteadyTime now);

    const SharedIntakeSetup m_setup;
    mutable std::mutex m_mutex;
    Sender m_me;                             ///< under the mutex
    std::map<std::uint64_t, Known> m_scans;  ///< by id; under the mutex, as all that follows
    std::set<std::uint64_t> m_adopted;
    std::map<std::uint64_t, bool> m_links;  ///< of scans, by id: whether they are active
    std::map<Sender, Other> m_others;
    std::deque<Undecided> m_undecided;  ///< in order of arrival
    std::size_t m_undecidedBytes = 0;
    std::optional<Sender> m_maker;  ///< who makes the map, as it reports itself
    SteadyTime m_makerReceived{};   ///< when it reported so last
};

}  // namespace leitstand
