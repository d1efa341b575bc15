#include "app/services/team/shared_intake.h"

#include <algorithm>
#include <utility>

#include "app/services/team/shared_evidence.h"
#include "core/base/words.h"
#include "core/event/all_samples.h"
#include "core/event/candidate_sample.h"
#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/sample.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_clock.h"
#include "core/mission/state/scan_state.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

constexpr std::size_t MostOthers = 64;  ///< stations that are remembered, whatever others publish

/// Whether it lies in the map of its sender.
bool isOfMap(const Sample& sample) {
    return sample.is<KeyScanSample>() || sample.is<ScanPosesSample>() || sample.is<ScanLinksSample>() ||
           sample.is<ScanBodiesSample>() || sample.is<MapCropSample>() || sample.is<RobotPlaceSample>();
}

bool isPlacedInMap(const Sample& sample) {
    return isOfMap(sample) || sample.is<FindSample>() || sample.is<CandidateSample>();
}

/// Returns the stamp of what the mission has of the same thing as @p sample; empty: nothing, or stamps do not
/// matter.
std::optional<Time> knownStamp(const MissionState& mission, const Sample& sample) {
    if (const auto* candidate = sample.as<CandidateSample>()) {
        const auto known = mission.candidates->find(candidate->id);
        if (known != mission.candidates->end()) return known->second.candidate.stamp;
    } else if (sample.is<MissionInfoSample>()) {
        if (mission.info) return mission.info->sample.stamp;
    } else if (sample.is<MapCropSample>()) {
        if (mission.crop) return mission.crop->sample.stamp;
    }
    return std::nullopt;
}

Time stampOf(const Sample& sample) {
    return visit(
        [](const auto& one) {
            if constexpr (requires { Time(one.stamp); }) return one.stamp;
            return Time{};
        },
        sample);
}

std::vector<std::uint64_t> scansOf(const Sample& sample) {
    std::vector<std::uint64_t> scans;
    if (const auto* poses = sample.as<ScanPosesSample>()) {
        for (const ScanPose& pose : poses->poses) scans.push_back(pose.scan);
    } else if (const auto* links = sample.as<ScanLinksSample>()) {
        for (const Link& link : links->links) scans.insert(scans.end(), {link.from, link.to});
    } else if (const auto* bodies = sample.as<ScanBodiesSample>()) {
        for (const BodiesOfScan& one : bodies->scans) scans.push_back(one.scan);
    }
    return scans;
}

}  // namespace

SharedIntake::SharedIntake(SharedIntakeSetup setup) : m_setup(std::move(setup)), m_me(m_setup.me) {
    const MissionStatePtr mission = m_setup.mission();
    for (const auto& [id, scan] : *mission->keyScans) m_scans[id] = {scan.entry.robot, scan.entry.stamp};
}

void SharedIntake::onEvent(const Event& event) {
    if (const auto* links = event.sample.as<ScanLinksSample>()) {
        const std::lock_guard lock(m_mutex);
        for (const Link& link : links->links) m_links[link.id] = link.active;
    }
    const auto* scan = event.sample.as<KeyScanSample>();
    if (scan == nullptr || !scan->scan) return;
    const std::lock_guard lock(m_mutex);
    m_scans.try_emplace(scan->id, Known{scan->scan->robot, scan->stamp});
}

bool SharedIntake::isAdopted(std::uint64_t id) const {
    const std::lock_guard lock(m_mutex);
    return m_adopted.contains(id);
}

bool SharedIntake::knows(const std::vector<std::uint64_t>& scans) const {
    return std::all_of(scans.begin(), scans.end(), [&](std::uint64_t id) { return m_scans.contains(id); });
}

void SharedIntake::publishOtherMap(std::uint64_t scan) const {
    if (!m_setup.notify) return;
    m_setup.notify(
        fill(translate("leitstand::Station",
                       "another station makes another map than this mission's (their scans {} differ): "
                       "it is not shown here; begin a new mission to see it"),
             scan));
}

bool SharedIntake::wants(const KeyScanSample& scan, Other& other) {
    if (!scan.scan) return false;
    const Known that{scan.scan->robot, scan.stamp};
    const auto known = m_scans.find(scan.id);
    const bool same = known != m_scans.end() && known->second == that;
    if (other.map == Map::Unknown && !m_scans.empty() && !same) {
        if (known == m_scans.end()) return true;  // unknown yet: it waits
        other.map = Map::Other;
        other.waiting.clear();
        publishOtherMap(scan.id);
        return false;
    }
    if (std::exchange(other.map, Map::Same) != Map::Same && m_setup.onJoined) m_setup.onJoined();
    if (same) return false;
    m_scans[scan.id] = that;
    m_adopted.insert(scan.id);
    return true;
}

bool SharedIntake::wants(const Event& event, Other& other) {
    const Sample& sample = event.sample;
    if (other.map == Map::Other && isPlacedInMap(sample)) return false;
    if (const auto* scan = sample.as<KeyScanSample>()) return wants(*scan, other);
    if (const auto* links = sample.as<ScanLinksSample>()) return wants(*links);
    if (const auto* bodies = sample.as<ScanBodiesSample>()) return wants(*bodies);
    if (const auto* find = sample.as<FindSample>()) return wants(*find);
    if (const auto* clock = sample.as<ClockSample>()) return wants(*clock);
    const auto known = knownStamp(*m_setup.mission(), sample);
    return !known || *known < stampOf(sample);
}

bool SharedIntake::wants(const ScanLinksSample& sample) const {
    return std::any_of(sample.links.begin(), sample.links.end(), [this](const Link& link) {
        const auto known = m_links.find(link.id);
        return known == m_links.end() || known->second != link.active;
    });
}

bool SharedIntake::wants(const ScanBodiesSample& sample) const {
    const MissionStatePtr mission = m_setup.mission();
    return std::any_of(sample.scans.begin(), sample.scans.end(), [&](const BodiesOfScan& one) {
        const auto known = mission->bodies->find(one.scan);
        return known == mission->bodies->end() ? !one.bodies.empty() : known->second != one.bodies;
    });
}

bool SharedIntake::wants(const FindSample& find) {
    const MissionStatePtr mission = m_setup.mission();
    const auto known = mission->finds->find({find.kind, find.number});
    if (known == mission->finds->end()) return true;
    const FindSample& ours = known->second.victim;
    if (ours.found == find.found) return ours.stamp < find.stamp;
    if (ours.found < find.found) return false;  // its station files it again, as below
    if (ours.station == m_setup.station && m_setup.fileAgain) m_setup.fileAgain(ours);
    return true;
}

bool SharedIntake::wants(const ClockSample& clock) const {
    const MissionStatePtr mission = m_setup.mission();
    if (!mission->clock) return true;
    const ClockSample& ours = mission->clock->sample;
    if (ours.station != m_setup.station || !beganByItself(ours)) return ours.stamp < clock.stamp;
    return !beganByItself(clock) || clock.stamp < ours.stamp;
}

bool SharedIntake::sharesMap() const {
    if (m_setup.holdsMap()) return true;
    const std::lock_guard lock(m_mutex);
    return m_scans.empty() || std::any_of(m_others.begin(), m_others.end(),
                                          [](const auto& other) { return other.second.map == Map::Same; });
}

void SharedIntake::receiveGrant(const RawEvent& event, const Sender& from, SteadyTime now) {
    const auto decoded = decodeStationEvent(event);
    const auto* grant = decoded ? decoded->sample.as<GrantSample>() : nullptr;
    if (grant == nullptr || grant->kind != GrantSample::Kind::Map) return;
    if (grant->action != GrantSample::Action::Hold) return;
    m_maker = from;
    m_makerReceived = now;
}

bool SharedIntake::waits(const Sample& sample, const Sender& from, const Other& other) const {
    if (sample.is<KeyScanSample>()) return other.map == Map::Unknown;
    if (isOfMap(sample)) return true;  // what need not wait also stays behind earlier samples
    // Finds of a map that may not be this one.
    return isPlacedInMap(sample) && other.map == Map::Unknown && m_maker == from && !m_scans.empty() &&
           !m_setup.holdsMap();
}

void SharedIntake::rejoined(const Sender& me) {
    const std::lock_guard lock(m_mutex);
    m_me = me;
}

void SharedIntake::take(RawEvent event, const Sender& from, SteadyTime now) {
    const std::lock_guard lock(m_mutex);
    const bool ours = from == m_me;
    if (ours && event.topic != station_topic::Grants) return;
    if (event.topic == station_topic::Grants) {
        if (!ours) receiveGrant(event, from, now);
        m_setup.enter(std::move(event));
    } else {
        decide(now);  // earlier samples come first
        receive(std::move(event), from, now);
    }
    decide(now);
    release(now);  // runs at least once a second
}

void SharedIntake::receive(RawEvent event, const Sender& from, SteadyTime now) {
    if (!m_others.contains(from) && m_others.size() >= MostOthers) return;
    const auto decoded = decodeStationEvent(event);
    if (!decoded) return m_setup.enter(std::move(event));  // counted as broken there, and kept
    Other& other = m_others[from];
    const Sample& sample = decoded->sample;
    if (isOfMap(sample) && m_setup.holdsMap()) {
        keepUndecided(std::move(event), from, now);
    } else if (!isOfMap(sample) && waits(sample, from, other)) {
        wait({std::move(event), now, {}}, other);  // whether it is wanted depends on whose map it lies in
    } else if (!wants(*decoded, other)) {
        return;
    } else if (waits(sample, from, other)) {
        Waiting one{std::move(event), now, scansOf(sample)};
        if (const auto* scan = sample.as<KeyScanSample>())
            one.scan = {scan->id, Known{scan->scan->robot, scan->stamp}};
        wait(std::move(one), other);
    } else {
        enter(std::move(event), sample);
    }
}

void SharedIntake::keepUndecided(RawEvent event, const Sender& from, SteadyTime now) {
    m_undecidedBytes += event.cdr->size();
    m_undecided.push_back({std::move(event), from, now});
    while (m_undecidedBytes > MostUndecidedBytes) {
        m_undecidedBytes -= m_undecided.front().event.cdr->size();
        m_undecided.pop_front();
    }
}

void SharedIntake::decide(SteadyTime now) {
    const bool ours = m_setup.holdsMap();
    std::deque<Undecided> due;
    while (!m_undecided.empty() && (!ours || now - m_undecided.front().since >= UntilDecided)) {
        m_undecidedBytes -= m_undecided.front().event.cdr->size();
        due.push_back(std::move(m_undecided.front()));
        m_undecided.pop_front();
    }
    if (ours) return;  // what is due is then left out
    for (Undecided& one : due) {
        // Another station that meant to make the map was wrong, too. A maker reported before this sample
        // proves nothing.
        if (m_maker && m_makerReceived >= one.since && one.from != *m_maker) continue;
        one.event.received = {};  // it enters now
        receive(std::move(one.event), one.from, now);
    }
}

void SharedIntake::wait(Waiting one, Other& other) {
    other.waiting.push_back(std::move(one));
    const auto scans = std::count_if(other.waiting.begin(), other.waiting.end(),
                                     [](const Waiting& each) { return each.scan.has_value(); });
    if (other.waiting.size() > MostWaiting || scans > std::ptrdiff_t{MostWaitingScans})
        other.waiting.pop_front();
}

void SharedIntake::enter(RawEvent event, Sample sample) {
    if (const auto* links = sample.as<ScanLinksSample>()) {
        for (const Link& link : links->links) m_links[link.id] = link.active;
    }
    if (takeOurSequences(sample, *m_setup.mission())) {
        if (auto cdr = encode(sample, event.type)) event.cdr = std::move(cdr).value();
    }
    m_setup.enter(std::move(event));
}

void SharedIntake::enterLate(Waiting one, Other& other) {
    // A station that makes the map by now has decided since.
    if (other.map != Map::Same || m_setup.holdsMap()) return;
    if (one.scan) {
        if (!m_scans.insert(*one.scan).second) return;
        m_adopted.insert(one.scan->first);
        return m_setup.enter(std::move(one.event));
    }
    const auto decoded = decodeStationEvent(one.event);
    if (decoded && wants(*decoded, other)) enter(std::move(one.event), decoded->sample);
}

void SharedIntake::releaseScans(Other& other) {
    if (other.map != Map::Same) return;
    for (auto one = other.waiting.begin(); one != other.waiting.end();) {
        if (!one->scan) {
            ++one;
            continue;
        }
        one->event.received = {};  // it enters now
        enterLate(std::move(*one), other);
        one = other.waiting.erase(one);
    }
}

void SharedIntake::release(SteadyTime now) {
    for (auto& [from, other] : m_others) {
        releaseScans(other);
        while (!other.waiting.empty()) {
            Waiting& first = other.waiting.front();
            const bool late = now - first.since >= LongestWait;
            if ((other.map == Map::Unknown || !knows(first.scans)) && !late) break;
            first.event.received = {};  // it enters now
            enterLate(std::move(first), other);
            other.waiting.pop_front();
        }
    }
}

}  // namespace leitstand
