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
#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/control/grants.h"
#include "core/robot/link/link_status.h"

namespace leitstand {

/// What a SharedIntake works with; may be called on any thread, with its lock held.
struct SharedIntakeSetup {
    Sender me;            ///< this process at first: what it says itself is left out
    std::string station;  ///< persistent identity
    std::function<MissionStatePtr()> mission = {};      ///< never null
    std::function<bool()> holdsMap = {};                ///< whether this station makes the map
    std::function<void(RawEvent)> enter = {};           ///< into the log, in this order
    std::function<void(const std::string&)> tell = {};  ///< for the operator, in words
    /// Another station turns out to make this mission's map.
    std::function<void()> onJoined = {};
    /// A find of this station gets a number of its own: another one had its number first.
    std::function<void(const VictimSample&)> fileAgain = {};
};

/// What other stations say of the mission, on its way into this station's log (docs/stations.md). Samples of
/// different topics overtake each other on the wire, and who comes late is told everything again; the log
/// gets each thing once, and after what it builds on:
///
/// - a key scan that the map has already is left out; one that has another's number counts instead of it, as
///   its station lost that when it was killed; poses and places wait until all their scans are there;
/// - of a find, a candidate, a clock and the mission's description the newest by its stamp counts; of two
///   finds of one number the one that was found first keeps it; a clock that a station began by itself gives
///   way;
/// - the station that makes the map hears nobody else's. It may be wrong about that for a moment: one that
///   was restarted makes the map as before until it hears that another one does by now. What it hears of a
///   map meanwhile is kept for UntilDecided; if the map turns out to be another one's, what that one said of
///   it is taken;
/// - a map that has no scan in common with this mission's, which is not empty, is another one: that is told
///   once, and nothing that lies in it is taken from that station. (Who meets a station tells it all scans
///   from the first on.)
///
/// Any thread.
class SharedIntake : public EventSink {
public:
    explicit SharedIntake(SharedIntakeSetup setup);

    /// This process is @p me in the domain from now on.
    void rejoined(const Sender& me);
    /// Takes what @p from said, on one of station_topic.
    void take(RawEvent event, const Sender& from, SteadyTime now);
    /// An event of our log: key scans and their links are known from then on.
    void onEvent(const Event& event) override;
    /// Whether this station's finds lie in the map that others know: it makes it, has none, or shares theirs.
    [[nodiscard]] bool sharesMap() const;
    /// Whether key scan @p id came from another station in this session.
    [[nodiscard]] bool isAdopted(std::uint64_t id) const;

    static constexpr std::chrono::seconds LongestWait{60};  ///< of poses for their scans
    static constexpr std::chrono::seconds UntilDecided{
        10};  ///< who makes the map: heartbeats come each second
    static constexpr std::size_t MostUndecidedBytes = std::size_t{256} << 20U;
    static constexpr std::size_t MostWaiting = 4096;     ///< of one station ...
    static constexpr std::size_t MostWaitingScans = 64;  ///< ... and with all their points

private:
    /// What tells a key scan from another of its number.
    struct Known {
        std::string robot;
        Time entered{};
        friend bool operator==(const Known&, const Known&) = default;
    };
    struct Waiting {
        RawEvent event;
        SteadyTime since;
        std::vector<std::uint64_t> scans;                          ///< that it builds on
        std::optional<std::pair<std::uint64_t, Known>> scan = {};  ///< that it is itself: id
    };
    /// What was said of a map while this station made it.
    struct Undecided {
        RawEvent event;
        Sender from;
        SteadyTime since;
    };
    enum class Map : std::uint8_t { Unknown, Same, Other };
    struct Other {
        Map map = Map::Unknown;
        std::deque<Waiting> waiting;  ///< what lies in its map, as it came
    };
    [[nodiscard]] bool wants(const Event& event, Other& other);
    [[nodiscard]] bool wants(const KeyScanSample& scan, Other& other);
    [[nodiscard]] bool wants(const ScanLinksSample& sample) const;
    [[nodiscard]] bool wants(const ScanBodiesSample& sample) const;
    [[nodiscard]] bool wants(const VictimSample& find);
    [[nodiscard]] bool wants(const ClockSample& clock) const;
    [[nodiscard]] bool waits(const Sample& sample, const Sender& from, const Other& other) const;
    void hear(RawEvent event, const Sender& from, SteadyTime now);
    void hearGrant(const RawEvent& event, const Sender& from, SteadyTime now);
    void keepUndecided(RawEvent event, const Sender& from, SteadyTime now);
    /// Takes what was undecided, if another station makes the map: what that one said, where it is known.
    void decide(SteadyTime now);
    void tellOtherMap(std::uint64_t scan) const;
    [[nodiscard]] bool knows(const std::vector<std::uint64_t>& scans) const;
    static void wait(Waiting one, Other& other);
    void enterLate(Waiting one, Other& other);  ///< where it is wanted by now
    void enter(RawEvent event, Sample sample);
    /// Scans of this map, before all else that waits: poses that overtook a scan wait for it, and are not to
    /// hold it up.
    void releaseScans(Other& other);
    void release(SteadyTime now);

    const SharedIntakeSetup m_setup;
    mutable std::mutex m_mutex;
    Sender m_me;                             ///< under the mutex
    std::map<std::uint64_t, Known> m_scans;  ///< by id; under the mutex, as all that follows
    std::set<std::uint64_t> m_adopted;
    std::map<std::uint64_t, bool> m_links;  ///< of scans, by id: whether they are active
    std::map<Sender, Other> m_others;
    std::deque<Undecided> m_undecided;  ///< as it came
    std::size_t m_undecidedBytes = 0;
    std::optional<Sender> m_maker;  ///< of the map, as it says itself
    SteadyTime m_makerHeard{};      ///< when that said so last
};

}  // namespace leitstand
