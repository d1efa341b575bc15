#include "app/services/team/mission_sharing.h"

#include <algorithm>
#include <chrono>
#include <utility>
#include <variant>

#include "app/services/domain/station_types.h"
#include "app/services/domain/topic_lane.h"
#include "app/services/log/sequencer.h"
#include "app/services/places/mission_map.h"
#include "app/services/team/shared_evidence.h"
#include "core/base/time.h"
#include "core/event/all_samples.h"
#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/sample.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/state/crop_state.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_clock.h"
#include "core/mission/state/scan_state.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

constexpr int Kept = 64;        ///< samples per topic, for stations that were away for a moment
constexpr int ScansAtOnce = 8;  ///< key scans that are under way before the others wait for them
/// Longest wait for a reader: a base time, plus what a link of 100 kB/s needs.
constexpr double PatienceAByte = 1e-5, Patience = 2.0;  ///< [s]
constexpr std::chrono::milliseconds Look(50);           ///< at a time, since others have something to publish
constexpr std::chrono::seconds UntilMatched(5);         ///< for a reader that was announced

bool isShared(std::string_view topic) {
    return std::any_of(StationTypes.begin(), StationTypes.end(),
                       [&](const StationType& one) { return one.shared && one.topic == topic; });
}

/// Returns the station that @p sample names; null when it names none.
const std::string* stationOf(const Sample& sample) {
    return visit(
        [](const auto& one) -> const std::string* {
            if constexpr (requires { std::string(one.station); }) return &one.station;
            return nullptr;
        },
        sample);
}

/// Returns what the undo takes back, or does again, in the end; null: unknown.
const Decision* meantBy(const MissionState& mission, const UndoSample& undo) {
    const Decision* meant = decisionAt(mission, undo.event);
    while (meant != nullptr) {
        const auto* other = std::get_if<UndoSample>(&meant->content);
        if (other == nullptr || other->event >= meant->sequence) break;
        meant = decisionAt(mission, other->event);
    }
    return meant;
}

}  // namespace

struct MissionSharing::Publishing {
    std::unique_ptr<BagReader> bag;
    std::set<std::uint64_t> sequences;  ///< of the scans that count
    std::optional<BagCursor> cursor;
    std::size_t bytes = 0;  ///< under way
    std::chrono::steady_clock::time_point since = std::chrono::steady_clock::now();
    bool begun = false;
};

MissionSharing::MissionSharing(Node& node, LiveMission& mission, MissionSharingSetup setup)
    : m_node(node), m_mission(mission), m_setup(std::move(setup)) {
    for (const auto& [topic, type, shared] : StationTypes) {
        if (!shared) continue;
        WriterSettings writer;
        writer.topic = topic;
        writer.type = type;
        writer.qos = {.reliability = Qos::Reliability::Reliable,
                      .durability = Qos::Durability::TransientLocal,
                      .depth = Kept};
        writer.flow = flowOf(type);
        auto made = node.publisher(writer);
        if (made)
            m_publishers.emplace(topic, std::move(made).value());
        else
            m_setup.notify(made.error().text);
    }
    m_thread = std::jthread([this](const std::stop_token& stop) { m_jobs.work(stop); });
}

MissionSharing::~MissionSharing() {
    close();
}

void MissionSharing::close() {
    m_jobs.cancel();
    m_thread.request_stop();
    if (m_thread.joinable()) m_thread.join();
}

bool MissionSharing::isReceived() const {
    const std::lock_guard lock(m_mutex);
    return !m_listeners.empty();
}

void MissionSharing::look() {
    std::set<Guid> now, scans;
    const Sender me = senderOf(m_node.guid());
    for (const RemoteEndpoint& one : m_node.endpoints()) {
        if (one.kind != RemoteEndpoint::Kind::Reader || !isShared(one.topic)) continue;
        if (senderOf(one.guid) == me) continue;  // this station's own log
        now.insert(one.guid);
        if (one.topic == station_topic::KeyScans) scans.insert(one.guid);
    }
    const bool holds = m_setup.holdsMap();
    const std::lock_guard lock(m_mutex);
    const bool came = !std::includes(m_scanReaders.begin(), m_scanReaders.end(), scans.begin(), scans.end());
    const bool took = holds && !m_heldMap;
    m_listeners = std::move(now);
    m_scanReaders = std::move(scans);
    m_heldMap = holds;
    if (m_listeners.empty() || (!came && !took)) return;
    m_jobs.submit([this](const std::stop_token& stop) { publishAll(stop); });
}

void MissionSharing::publishFindsAgain() {
    m_jobs.submit([this](const std::stop_token& stop) {
        if (!stop.stop_requested()) publishFinds(*m_mission.state());
    });
}

void MissionSharing::submit(const Sample& sample, std::string_view topic) {
    m_jobs.submit([this, sample, topic = std::string(topic)](const std::stop_token& stop) {
        if (!stop.stop_requested()) write(sample, topic);
    });
}

void MissionSharing::publish(const Sample& sample, std::string_view topic) {
    if (isReceived()) submit(sample, topic);
}

void MissionSharing::onEvent(const Event& event) {
    if (!event.robot.empty() || !isReceived()) return;
    if (const auto* undo = event.sample.as<UndoSample>()) {
        if (undo->station != m_setup.station) return;
        return m_jobs.submit([this, undo = *undo](const std::stop_token& stop) {
            if (!stop.stop_requested()) notifyUndone(undo);
        });
    }
    // The operator's changes of them come by publish(); what a station logs of them at its start is its own.
    if (event.topic == station_topic::Clock || event.topic == station_topic::Mission) return;
    if (!isShared(event.topic)) return;
    const auto* scan = event.sample.as<KeyScanSample>();
    const std::string* station = stationOf(event.sample);
    const bool ours =
        scan != nullptr ? !m_setup.isAdopted(scan->id) : station != nullptr && *station == m_setup.station;
    const bool find = event.topic == station_topic::Victims || event.topic == station_topic::Candidates;
    if (ours && (!find || m_setup.sharesMap())) submit(event.sample, event.topic);
}

void MissionSharing::write(const Sample& sample, std::string_view topic) {
    const Sample reported = forOthers(sample);
    auto cdr = encode(reported, typeOf(reported));
    if (cdr) write(*cdr, topic);  // the log has reported what cannot be encoded
}

void MissionSharing::write(const Payload& cdr, std::string_view topic) {
    const auto publisher = m_publishers.find(topic);
    // A failure means that the node has left.
    if (publisher != m_publishers.end()) static_cast<void>(publisher->second->write(cdr));
}

void MissionSharing::publishAll(const std::stop_token& stop) {
    publishFinds(*m_mission.state());  // the operator's work does not wait for scans
    publishClock(*m_mission.state());
    if (!m_setup.holdsMap()) return;
    if (auto publishing = scansToPublish()) publishScans(std::move(publishing), stop);
}

std::shared_ptr<MissionSharing::Publishing> MissionSharing::scansToPublish() {
    if (!m_mission.flush()) return nullptr;  // the log has reported why
    auto publishing = std::make_shared<Publishing>();
    const MissionStatePtr mission = m_mission.state();
    for (const auto& [id, scan] : *mission->keyScans) publishing->sequences.insert(scan.sequence);
    auto bag = BagReader::open(m_setup.folder);
    if (!bag) {
        m_setup.notify(bag.error().text);
        return nullptr;
    }
    publishing->bag = std::move(bag).value();
    BagQuery query;
    query.topics = {std::string(station_topic::KeyScans), std::string(station_topic::ScanLinks)};
    publishing->cursor.emplace(publishing->bag->read(query));
    return publishing;
}

void MissionSharing::publishScans(std::shared_ptr<Publishing> publishing, const std::stop_token& stop) {
    const auto publisher = m_publishers.find(station_topic::KeyScans);
    if (publisher == m_publishers.end() || stop.stop_requested()) return;
    const auto goOn = [&] {
        m_jobs.submit(
            [this, publishing](const std::stop_token& stopped) { publishScans(publishing, stopped); });
    };
    const double waited = secondsBetween(publishing->since, steadyNow());
    if (!publishing->begun) {
        std::size_t announced = 0;
        {
            const std::lock_guard lock(m_mutex);
            announced = m_scanReaders.size();
        }
        // This station's own log is a reader, too.
        const bool all = publisher->second->matched() > static_cast<int>(announced);
        if (!all && waited < toSeconds(UntilMatched)) {
            std::this_thread::sleep_for(Look);
            return goOn();
        }
        publishing->begun = true;
    } else if (!publisher->second->waitForAcknowledgments(Look)) {
        if (waited < Patience + PatienceAByte * static_cast<double>(publishing->bytes)) return goOn();
    }
    publishing->bytes = 0;
    publishing->since = std::chrono::steady_clock::now();
    for (int i = 0; i < ScansAtOnce;) {
        const auto scan = publishing->cursor->next();
        if (!scan) return publishMap(*m_mission.state());
        if (scan->topic == station_topic::ScanLinks) {
            const auto event = decodeStationEvent(*scan);
            const auto* reported = event ? event->sample.as<ScanLinksSample>() : nullptr;
            if (reported == nullptr) continue;
            // Readers must distinguish it from what they publish themselves.
            write(ScanLinksSample{reported->stamp, m_setup.station, reported->links},
                  station_topic::ScanLinks);
            publishing->bytes += scan->cdr->size();
            continue;
        }
        if (!publishing->sequences.contains(scan->sequence)) continue;  // another scan of its number counts
        write(scan->cdr, station_topic::KeyScans);
        publishing->bytes += scan->cdr->size();
        ++i;
    }
    goOn();
}

void MissionSharing::publishMap(const MissionState& mission) {
    const Time now = stationTime();
    if (!mission.keyScans->empty())
        write(ScanPosesSample{now, m_setup.station, ScanPosesSample::Cause::Registration, posesOf(mission)},
              station_topic::ScanPoses);
    if (std::vector<Link> loops = loopsOf(mission); !loops.empty())
        write(ScanLinksSample{now, m_setup.station, std::move(loops)}, station_topic::ScanLinks);
    for (ScanBodiesSample& bodies : inSamples(*mission.bodies, now)) {
        bodies.station = m_setup.station;
        write(bodies, station_topic::ScanBodies);
    }
    if (mission.crop) {
        MapCropSample crop = mission.crop->sample;
        crop.polygon = areaInMap(mission);  // as it lies in the map that is sent with it
        crop.station = m_setup.station;
        write(crop, station_topic::MapCrop);
    }
    const RobotsInMapPtr robots = m_setup.robots();
    for (const auto& [name, robot] : mission.robots) {
        if (!robot->place) continue;
        RobotPlaceSample place = robot->place->sample;
        for (const RobotInMap& one : *robots) {
            if (one.robot != name || !one.placed || !one.odomInMap) continue;
            place.measured = one.stamp;
            place.baseInMap = one.baseInMap;
            place.odomInMap = *one.odomInMap;
        }
        place.station = m_setup.station;
        write(place, station_topic::RobotPlaces);
    }
}

void MissionSharing::publishClock(const MissionState& mission) {
    // A clock that began by itself becomes the team's only if this station makes the map.
    if (mission.clock && (m_setup.holdsMap() || !beganByItself(mission.clock->sample)))
        write(mission.clock->sample, station_topic::Clock);
    if (mission.info) write(mission.info->sample, station_topic::Mission);
}

void MissionSharing::publishFinds(const MissionState& mission) {
    if (!m_setup.sharesMap()) return;
    for (const auto& [key, find] : *mission.finds) {
        FindSample published = find.victim;
        published.station = m_setup.station;
        write(published, station_topic::Victims);
    }
    if (!m_setup.holdsMap()) return;
    for (const auto& [id, candidate] : *mission.candidates)
        write(candidate.candidate, station_topic::Candidates);
}

void MissionSharing::notifyUndone(const UndoSample& undo) {
    const MissionStatePtr mission = m_mission.state();
    const Decision* meant = meantBy(*mission, undo);
    if (meant == nullptr) return;
    if (const auto* poses = std::get_if<ScanPosesSample>(&meant->content)) {
        ScanPosesSample now{undo.stamp, m_setup.station, ScanPosesSample::Cause::Operator, {}};
        for (const ScanPose& pose : poses->poses) {
            const auto scan = mission->keyScans->find(pose.scan);
            if (scan != mission->keyScans->end()) now.poses.push_back(scan->second.pose);
        }
        write(now, station_topic::ScanPoses);
    } else if (const auto* loop = std::get_if<ScanLinksSample>(&meant->content)) {
        ScanLinksSample now{undo.stamp, m_setup.station, {}};
        for (const Link& link : loopsOf(*mission)) {
            const bool reported = std::any_of(loop->links.begin(), loop->links.end(),
                                              [&](const Link& one) { return one.id == link.id; });
            if (reported) now.links.push_back(link);
        }
        write(now, station_topic::ScanLinks);
    } else if (std::holds_alternative<MapCropSample>(meant->content)) {
        MapCropSample now;
        if (mission->crop) now = mission->crop->sample;
        now.polygon = areaInMap(*mission);
        now.stamp = undo.stamp;
        now.station = m_setup.station;
        write(now, station_topic::MapCrop);
    } else if (const auto* find = std::get_if<FindSample>(&meant->content)) {
        const auto known = mission->finds->find({find->kind, find->number});
        FindSample now = known != mission->finds->end() ? known->second.victim : *find;
        if (known == mission->finds->end()) now.status = FindSample::Status::Discarded;
        now.stamp = undo.stamp;
        now.station = m_setup.station;
        write(now, station_topic::Victims);
    }
}

}  // namespace leitstand
