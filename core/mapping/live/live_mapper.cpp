#include "core/mapping/live/live_mapper.h"

#include <algorithm>
#include <utility>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/growing_map.h"
#include "core/mapping/live/map_decisions.h"
#include "core/mapping/live/map_links.h"
#include "core/mapping/live/registration/scan_registration.h"

namespace leitstand {

struct LiveMapper::State {
    State(std::string station, LiveSettings settings) : map(std::move(station), std::move(settings)) {}

    GrowingMap map;
    ScanRegistration registration{map};
    MapDecisions decisions{map};
    MapLinks links{map};
};

LiveMapper::LiveMapper(std::string station, LiveSettings settings)
    : m_state(std::make_unique<State>(std::move(station), std::move(settings))) {}
LiveMapper::~LiveMapper() = default;
LiveMapper::LiveMapper(LiveMapper&&) noexcept = default;
LiveMapper& LiveMapper::operator=(LiveMapper&&) noexcept = default;

void LiveMapper::setBody(const std::string& robot, RobotBody body) {
    m_state->map.robots[robot].body = std::move(body);
}

void LiveMapper::setCrop(MapCrop crop) {
    m_state->map.cropped.setCrop(crop);
    m_state->map.settings.crop = std::move(crop);
    for (LiveKeyScan& scan : m_state->map.map.scans) m_state->map.cropped.fit(scan, m_state->map.clouds);
    m_state->map.matcher.mapChanged();
}

bool LiveMapper::leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies) {
    LiveKeyScan* const scan = m_state->map.find(id);
    if (scan == nullptr) return false;
    const std::vector<BodyInScan> before = m_state->map.cropped.bodies(id);
    if (before == bodies) return false;
    // Points that the area hides now return to the map once it is wider.
    const ScanPtr whole = scan->kept ? scan->kept->whole() : scan->scan;
    const std::vector<bool> on = onOthers(whole->points, placed(bodies, Pose::Identity()), Pose::Identity());
    if (before.empty() && std::find(on.begin(), on.end(), true) == on.end()) return false;
    m_state->map.cropped.setBodies(id, std::move(bodies));
    m_state->map.cropped.fit(*scan, m_state->map.clouds);
    m_state->map.matcher.mapChanged();
    return true;
}

std::vector<BodyInScan> LiveMapper::bodiesIn(std::uint64_t id) const {
    return m_state->map.cropped.bodies(id);
}

void LiveMapper::place(const std::string& robot, const Pose& baseInMap) {
    m_state->map.robots[robot].placedInMap = baseInMap;
    m_state->map.robots[robot].beginsPart = false;
}

void LiveMapper::beginPart(const std::string& robot) {
    m_state->map.robots[robot].beginsPart = true;
}

bool LiveMapper::isAstray(const std::string& name) const {
    const auto found = m_state->map.robots.find(name);
    if (found == m_state->map.robots.end()) return false;
    const RobotTrack& robot = found->second;
    if (!robot.known || !robot.lost || robot.placedInMap) return false;
    return !robot.odometry ||
           m_state->map.settings.match.odometry.share * robot.way > m_state->map.settings.fit.mostDeviation;
}

ScannerCalibration LiveMapper::calibration(const std::string& name) const {
    const auto robot = m_state->map.robots.find(name);
    return robot != m_state->map.robots.end() ? robot->second.scanner.calibration() : ScannerCalibration{};
}

void LiveMapper::recalibrate(const std::string& name) {
    const auto robot = m_state->map.robots.find(name);
    // The next scan may be of a turn that had begun before.
    if (robot != m_state->map.robots.end()) robot->second.scanner.restart(m_state->map.nextId);
}

std::optional<RobotFix> LiveMapper::fix(const std::string& name) const {
    const auto robot = m_state->map.robots.find(name);
    if (robot == m_state->map.robots.end() || !robot->second.known) return std::nullopt;
    const RobotTrack& track = robot->second;
    if (track.placedInMap)
        return RobotFix{track.stamp, *track.placedInMap, 0.0, static_cast<std::uint8_t>(ScanDoubt::Odometry)};
    return RobotFix{track.stamp,        track.sensorInMap * track.sensorInBase.inverse(),
                    track.certainty,    track.doubts,
                    track.wheels.way(), m_state->map.partOf(track)};
}

LiveMapPtr LiveMapper::map() const {
    return std::make_shared<const LiveMap>(m_state->map.map);
}

MapUpdate LiveMapper::add(const LiveScan& scan, Time now, std::span<const PlacedBody> others) {
    return m_state->registration.add(scan, now, others);
}
Result<ScanPosesSample> LiveMapper::accept(std::uint64_t id, Time now) {
    return m_state->decisions.accept(id, now);
}
Result<ScanPosesSample> LiveMapper::reject(std::uint64_t id, Time now) {
    return m_state->decisions.reject(id, now);
}
Result<ScanPosesSample> LiveMapper::retry(std::uint64_t id, const RetrySettings& settings, Time now) {
    return m_state->decisions.retry(id, settings, now);
}
Result<ScanPosesSample> LiveMapper::rewind(Time moment, Time now) {
    return m_state->decisions.rewind(moment, now);
}
void LiveMapper::restore(const KeyScanSample& keyScan) {
    m_state->decisions.restore(keyScan);
}
void LiveMapper::adopt(const KeyScanSample& keyScan) {
    m_state->decisions.adopt(keyScan);
}
void LiveMapper::beginBlock() {
    m_state->decisions.beginBlock();
}
void LiveMapper::follow(std::span<const ScanPose> poses) {
    m_state->decisions.follow(poses);
}
std::optional<ScanLinksSample> LiveMapper::takeLinks() {
    return m_state->decisions.takeLinks();
}
void LiveMapper::restore(const ScanLinksSample& links) {
    m_state->links.restore(links);
}
void LiveMapper::followLoops(std::span<const Link> loops) {
    m_state->links.followLoops(loops);
}
void LiveMapper::takeAsSolved() {
    m_state->links.takeAsSolved();
}
std::optional<SoughtPlace> LiveMapper::sought() {
    return m_state->links.sought();
}
std::optional<ScanLinksSample> LiveMapper::recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                      Time now) {
    return m_state->links.recognised(sought, scanInMap, now);
}
Result<ScanLinksSample> LiveMapper::propose(std::uint64_t id, const Pose& scanInMap, Time now) {
    return m_state->links.propose(id, scanInMap, now);
}
bool LiveMapper::meetsMore() const {
    return m_state->links.meetsMore();
}
std::optional<ScanLinksSample> LiveMapper::meetMore(Time now) {
    return m_state->links.meetMore(now);
}
void LiveMapper::meetNoMore() {
    m_state->links.meetNoMore();
}
Result<ScanLinksSample> LiveMapper::moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                           Time now) {
    return m_state->links.moveTo(scan, kind, scanInMap, now);
}
std::optional<ScanLinksSample> LiveMapper::join(const std::map<std::uint64_t, Pose>& scansInMap, Time now) {
    return m_state->links.join(scansInMap, now);
}
std::optional<MapProblem> LiveMapper::problem() {
    return m_state->links.problem();
}
MapProblem LiveMapper::problemWith(std::span<const Link> links) const {
    return m_state->links.problemWith(links);
}
Settled LiveMapper::settle(const MapSolution& solution, Time now) {
    return m_state->links.settle(solution, now);
}
void LiveMapper::leaveUnsettled() {
    m_state->links.leaveUnsettled();
}
std::set<std::uint64_t> LiveMapper::together(std::uint64_t id) const {
    return m_state->links.together(id);
}

}  // namespace leitstand
