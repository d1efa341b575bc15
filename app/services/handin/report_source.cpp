#include "app/services/handin/report_source.h"

#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "app/services/coverage/logged_views.h"
#include "app/services/finds/evidence_in_log.h"
#include "app/services/handin/writing/relative_names.h"
#include "app/services/log/decoded_log.h"
#include "app/services/log/event_decoder.h"
#include "app/services/log/log_entry.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/replay/bag_history.h"
#include "app/services/offline/offline_map.h"
#include "app/services/places/frame_tracks.h"
#include "app/services/places/mission_map.h"
#include "app/services/progress_part.h"
#include "core/base/words.h"
#include "core/event/cloud_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample_header.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_pose.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/mapping/live/map/cropped_scans.h"
#include "core/mission/state/fold.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

constexpr double OdometryApart = 0.01;         ///< nearer poses add nothing new [m]
constexpr double OdometryTurned = degrees(3);  ///< poses that turned less add nothing new [rad]

std::string nameOf(const fs::path& folder) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    const fs::path last = whole.has_filename() ? whole : whole.parent_path();
    std::error_code ignored;
    return (fs::is_regular_file(whole, ignored) ? last.stem() : last.filename()).string();
}

}  // namespace

ReportSource::ReportSource() = default;
ReportSource::~ReportSource() = default;
ReportSource::ReportSource(ReportSource&&) noexcept = default;
ReportSource& ReportSource::operator=(ReportSource&&) noexcept = default;

const std::vector<RobotDescription>& ReportSource::robots() const {
    return m_decoder->robots();
}

Result<ReportSource> ReportSource::open(const fs::path& folder, const Progress& progress) {
    auto bag = BagReader::open(folder);
    if (!bag) return bag.error();
    ReportSource source;
    source.m_bag = std::move(bag).value();
    source.m_decoder = std::make_unique<EventDecoder>(robotsOf(folder, *source.m_bag, source.m_warnings));
    source.m_input.name = nameOf(folder);
    for (const RobotDescription& robot : source.robots()) source.m_input.robots.push_back(robot.name);
    source.readState();
    source.readKeyScans(folder, part(progress, 0.1, 0.5));
    if (!source.m_hasKeyScans && source.m_bag->lastSequence() > 0)
        source.registerClouds(folder, part(progress, 0.1, 0.8));
    source.readWays(part(progress, 0.8, 0.9));
    source.readViews(part(progress, 0.9, 1.0));
    if (source.m_bag->lastSequence() == 0)
        source.m_warnings.push_back(translate("leitstand::ReportText", "the mission holds no events"));
    const auto& problems = source.m_bag->problems();
    source.m_warnings.insert(source.m_warnings.end(), problems.begin(), problems.end());
    for (const auto& [topic, errors] : source.m_decoder->errors()) {
        source.m_warnings.push_back(
            fill(translate("leitstand::ReportText", "{} samples of {} make no sense, the last one: {}"),
                 errors.count, topic, errors.last));
    }
    std::vector<std::string> allWarnings;  // registration reports damage too
    for (std::string& warning : source.m_warnings) {
        std::string named = namedWithin(std::move(warning), folder);
        if (std::find(allWarnings.begin(), allWarnings.end(), named) == allWarnings.end())
            allWarnings.push_back(std::move(named));
    }
    source.m_warnings = std::move(allWarnings);
    return source;
}

void ReportSource::readState() {
    BagHistory history(*m_bag, *m_decoder);
    m_decoder->setDepths(false);
    m_input.state = stateAt(history, m_bag->lastSequence());
    m_decoder->setDepths(true);
}

void ReportSource::readKeyScans(const fs::path& folder, const Progress& progress) {
    const auto& known = *m_input.state.keyScans;
    const std::map<std::uint64_t, std::uint64_t> parts =
        partsOf(m_input.state, linksOf(folder, m_input.state));
    std::size_t aside = 0;
    const MapCrop crop = cropOf(m_input.state).value_or(MapCrop{});
    for (KeyScanSample& sample : keyScansOf(*m_bag)) {
        m_hasKeyScans = true;
        const auto state = known.find(sample.id);
        if (state == known.end() || state->second.pose.trust == ScanTrust::SetAside) continue;  // undone too
        if (state->second.pose.trust == ScanTrust::Uncertain) {
            ++m_input.uncertain;
            continue;
        }
        ScanPtr scan = std::move(sample.scan);
        // Spectators may have been scanned before the area was drawn, other robots before they were placed.
        const auto bodies = m_input.state.bodies->find(sample.id);
        std::vector<PlacedBody> others;
        if (bodies != m_input.state.bodies->end())
            others = placed(bodies->second, state->second.pose.scanInMap);
        // Nobody knows how parts that have not met lie relative to the area.
        const bool met = parts.at(sample.id) == 0;
        if (!met) ++aside;
        scan = insideCrop(scan, met ? crop : MapCrop{}, state->second.pose.scanInMap, others);
        m_input.scans.push_back({.id = sample.id,
                                 .scan = std::move(scan),
                                 .scanInMap = state->second.pose.scanInMap,
                                 .sensorInBase = sample.sensorInBase});
        if (progress.cancelled()) return;
    }
    std::sort(m_input.scans.begin(), m_input.scans.end(),
              [](const ReportScan& a, const ReportScan& b) { return a.id < b.id; });
    if (m_hasKeyScans && m_input.scans.empty() && m_input.uncertain == 0) {
        m_warnings.push_back(
            translate("leitstand::ReportText",
                      "there is no map: all scans of the mission were set aside or taken back"));
        m_mentionsMap = true;
    }
    if (aside > 0) {
        m_warnings.push_back(fill(
            translate("leitstand::ReportText",
                      "{} of {} scans are of parts of the map that have not met the rest: they lie aside "
                      "in it, since nobody knows where they belong"),
            aside, m_input.scans.size()));
    }
    if (m_input.uncertain > 0) {
        m_warnings.push_back(
            fill(translate("leitstand::ReportText",
                           "{} scans are not in the map, since they do not fit and nobody decided on them"),
                 m_input.uncertain));
    }
}

void ReportSource::registerClouds(const fs::path& folder, const Progress& progress) {
    auto map = mapOffline(folder, progress);
    if (!map) {
        m_warnings.push_back(
            fill(translate("leitstand::ReportText", "there is no map: {}"), map.error().text));
        m_mentionsMap = true;
        return;
    }
    for (const OfflineScan& one : map->scans) {
        m_input.scans.push_back(
            {.scan = one.scan.scan, .scanInMap = one.scan.poseInMap, .sensorInBase = one.sensorInBase});
    }
    m_warnings.push_back(
        fill(translate("leitstand::ReportText",
                       "no station made a map of this mission: {} of its {} scans were registered for "
                       "this report, without anyone's check"),
             m_input.scans.size(), map->read));
    m_warnings.insert(m_warnings.end(), map->warnings.begin(), map->warnings.end());
}

void ReportSource::readWays(const Progress& progress) {
    BagQuery query;
    query.topics = {std::string(station_topic::RobotPlaces)};
    for (const RobotDescription& robot : robots()) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role == StreamRole::Odometry || stream.role == StreamRole::Mode)
                query.topics.push_back(stream.topic);
        }
    }
    const auto take = [this](const Event& event) {
        if (const auto* odometry = event.sample.as<OdometrySample>()) {
            auto& track = m_input.odometry[event.robot];
            const Time stamp = odometry->header.stamp == Time{} ? event.received : odometry->header.stamp;
            const bool still =
                !track.empty() &&
                distanceBetween(track.back().baseInMap, odometry->baseInOdom) < OdometryApart &&
                angleBetween(track.back().baseInMap, odometry->baseInOdom) < OdometryTurned &&
                stamp - track.back().time < std::chrono::milliseconds(400);
            if (!still) track.push_back({stamp, odometry->baseInOdom});
        } else if (const auto* mode = event.sample.as<ModeSample>()) {
            m_input.modes[event.robot].push_back({event.received, mode->mode, mode->autonomous});
        } else if (const auto* place = event.sample.as<RobotPlaceSample>()) {
            if (place->certain) m_input.places[place->robot].push_back({place->measured, place->baseInMap});
        }
    };
    forEachEvent(*m_bag, *m_decoder, query, take, progress);
    if (progress.cancelled()) return;
    for (auto& [robot, track] : m_input.odometry) {
        std::stable_sort(track.begin(), track.end(),
                         [](const PathPose& a, const PathPose& b) { return a.time < b.time; });
    }
}

void ReportSource::readViews(const Progress& progress) {
    const bool ours = std::any_of(m_input.scans.begin(), m_input.scans.end(),
                                  [](const ReportScan& scan) { return scan.id != 0; });
    if (!ours) return;
    LoggedViews logged = loggedViews(*m_bag, *m_decoder, progress);
    m_input.views = std::move(logged.views);
    if (logged.leftOut > 0) {
        m_warnings.push_back(fill(
            translate("leitstand::ReportText",
                      "cameras looked from more places than are counted: {} views are missing in what was "
                      "searched"),
            logged.leftOut));
    }
}

Result<Event> ReportSource::event(std::uint64_t sequence) {
    const auto raw = m_bag->event(sequence);
    if (!raw)
        return Error{leitstand::fill(translate("leitstand::Error", "event {} is not in the log"), sequence)};
    auto found = decodedAlone(*m_bag, *m_decoder, *raw);
    if (!found)
        return Error{leitstand::fill(translate("leitstand::Error", "event {} ({}) cannot be read"), sequence,
                                     raw->topic)};
    return std::move(*found);
}

Result<Event> ReportSource::event(const VictimEvidence& evidence, const FindSample& find) {
    const std::uint64_t sequence = sequenceInLog(*m_bag, *m_decoder, evidence, find);
    if (sequence == 0) return Error{translate("leitstand::Error", "another station has it in its log")};
    return event(sequence);
}

std::optional<Pose> ReportSource::sensorInBase(const Event& event) {
    constexpr auto About = std::chrono::seconds(3);
    const SampleHeader* header = nullptr;
    if (const auto* cloud = event.sample.as<CloudSample>()) header = &cloud->header;
    if (const auto* ranges = event.sample.as<RangesSample>()) header = &ranges->header;
    const auto robot = std::find_if(robots().begin(), robots().end(),
                                    [&](const RobotDescription& one) { return one.name == event.robot; });
    if (header == nullptr || robot == robots().end()) return std::nullopt;
    FrameTracks frames(*robot);
    BagQuery fixed, moving;
    for (const StreamDescription& stream : robot->streams) {
        if (stream.role == StreamRole::StaticTransforms) fixed.topics.push_back(stream.topic);
        if (stream.role == StreamRole::Transforms || stream.role == StreamRole::Odometry)
            moving.topics.push_back(stream.topic);
    }
    moving.from = event.received - About;
    moving.to = event.received + About;
    for (const BagQuery& query : {fixed, moving}) {
        forEachEvent(*m_bag, *m_decoder, query, [&](const Event& one) {
            if (one.robot == event.robot) frames.add(one);
        });
    }
    const Time stamp = header->stamp == Time{} ? event.received : header->stamp;
    return frames.inBase(event.sensor, header->frame, stamp);
}

}  // namespace leitstand
