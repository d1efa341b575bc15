#include "app/services/station/station.h"

#include <utility>

#include "app/services/domain/seen_topics.h"
#include "app/services/log/sequencer.h"
#include "app/services/station/station_state.h"
#include "core/base/words.h"
#include "core/event/motion_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"

namespace leitstand {

Result<std::unique_ptr<Station>> Station::open(const StationSettings& settings, StationListener listener) {
    auto state = std::make_unique<State>();
    state->settings = settings;
    state->listener = std::move(listener);
    if (auto started = state->start(); !started) return started.error();
    return std::unique_ptr<Station>(new Station(std::move(state)));
}

Station::Station(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Station::~Station() = default;

const std::vector<RobotDescription>& Station::robots() const {
    return m_state->settings.mission.robots;
}

RobotView Station::robot(const std::string& name) const {
    return m_state->view(name);
}

std::optional<VirtualScanView> Station::surroundings(const std::string& robot) const {
    const RobotLine* const line = m_state->line(robot);
    return line == nullptr ? std::nullopt : line->sight().view();
}

std::optional<SteadyTime> Station::scanned(const std::string& robot) const {
    const RobotLine* const line = m_state->line(robot);
    return line == nullptr ? std::nullopt : line->sight().scanned();
}

MissionStatePtr Station::mission() const {
    return m_state->mission->state();
}

StationClock& Station::clock() {
    return *m_state->clock;
}

StationAlarms& Station::alarms() {
    return *m_state->alarms;
}

Result<void> Station::describe(MissionInfoSample info) {
    info.stamp = stationTime();
    info.station = m_state->memory->identity().id;
    auto recorded = m_state->mission->record(info, station_topic::Mission);
    if (recorded) m_state->sharing->publish(info, station_topic::Mission);
    return recorded;
}

std::shared_ptr<const SearchedFloor> Station::searched() const {
    return m_state->coverage->searched();
}

FindDesk& Station::finds() {
    return *m_state->finds;
}

StationMapping& Station::mapping() {
    return *m_state->mapping;
}

const std::filesystem::path& Station::folder() const {
    return m_state->settings.mission.folder;
}

LiveMissionStatus Station::log() const {
    return m_state->mission->status();
}

std::vector<WireComplaint> Station::mismatches() const {
    std::vector<WireComplaint> complaints;
    for (const Mismatch& mismatch : m_state->node->mismatches()) complaints.push_back(mismatch.complaint);
    return complaints;
}

void Station::setDriveFocus(const std::string& robot) {
    giveSticks(m_state->lines, robot);
    for (const auto& [name, line] : m_state->lines) {
        if (name != robot) m_state->joints->halt(name);
    }
}

void Station::setStick(const DriveVelocity& sticks, bool withoutEyes) {
    for (const auto& [name, line] : m_state->lines) {
        if (line->drive() == nullptr || m_state->brakes->isRunning(name)) continue;
        if (line->drive()->status().focus) line->drive()->set(sticks, withoutEyes);
    }
}

void Station::halt() {
    const MissionStatePtr recorded = mission();
    for (const auto& [name, line] : m_state->lines) {
        m_state->joints->halt(name);  // also of robots that nobody drives
        if (line->drive() == nullptr || !line->drive()->status().focus) continue;
        line->drive()->halt();
        const auto robot = recorded->robots.find(name);
        if (robot != recorded->robots.end() && robot->second->mode && robot->second->mode->sample.autonomous)
            (void)setMode(name, "teleoperation");  // one that takes no modes stops by its sticks alone
    }
}

void Station::selectCamera(const std::string& robot, const std::string& sensor) {
    if (RobotLine* const line = m_state->line(robot)) line->sight().selectCamera(sensor);
    m_state->streams->selectCamera(robot, sensor);
}

void Station::requestGrant(const std::string& robot) {
    m_state->grants->requestGrant(driveGrant(robot));
}

void Station::releaseGrant(const std::string& robot) {
    m_state->grants->release(driveGrant(robot));
}

void Station::answerRequest(const std::string& robot, bool consent) {
    m_state->grants->answerRequest(driveGrant(robot), consent);
}

GrantView Station::mapGrant() const {
    return m_state->grants->view(MapGrant);
}

void Station::giveMap() {
    m_state->grants->answerRequest(MapGrant, true);
    m_state->grants->requestGrant(MapGrant);  // it returns here when the other station ends
}

void Station::stopAll() {
    m_state->stops->stopAll();
}

void Station::stop(const std::string& robot) {
    m_state->stops->stop(robot);
}

Result<void> Station::release(const std::string& robot) {
    return m_state->stops->release(robot);
}

Result<void> Station::setMode(const std::string& robot, const std::string& mode) {
    // In teleoperation it follows the sticks, which are limited by themselves.
    const bool byItself = !mode.ends_with("teleoperation");
    if (auto may = maySend(robot); byItself && !may) return may;
    return m_state->request(robot, StreamRole::ModeCommand,
                            ModeCommandSample{stationTime(), m_state->memory->identity().id, mode});
}

Result<void> Station::maySend(const std::string& robot) const {
    const StationBrakes& brakes = *m_state->brakes;
    if (brakes.isRunning(robot))
        return Error{leitstand::fill(
            translate("leitstand::Station", "{} is sent nowhere during its brake test"), robot)};
    if (brakes.refuses(robot))
        return Error{leitstand::fill(
            translate(
                "leitstand::Station",
                "{} failed its brake test: it is sent nowhere until it passes or is driven nevertheless"),
            robot)};
    return {};
}

Result<void> Station::goTo(const std::string& robot, const PoseSample& goal) {
    if (auto may = maySend(robot); !may) return may;
    // Here and not by what views last saw: a map that moves as STOP is pressed would send the robot on.
    if (!m_state->stops->allowsDriving(robot))
        return Error{leitstand::fill(
            translate("leitstand::Station", "{} is stopped: it is sent nowhere before its release"), robot)};
    PoseSample stamped = goal;
    stamped.header.stamp = stationTime();
    RobotLine* const line = m_state->line(robot);
    if (line == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    return line->goTo(stamped);
}

void Station::cancelGoal(const std::string& robot) {
    if (RobotLine* const line = m_state->line(robot)) line->cancelGoal();
}

Result<void> Station::call(const std::string& robot, const std::string& service, bool value) {
    RobotLine* const line = m_state->line(robot);
    if (line == nullptr)
        return Error{leitstand::fill(
            translate("leitstand::Station", "\"{}\" is none of the station's robots"), robot)};
    const GrantView grant = m_state->view(robot).grant;
    if (!grant.mine && !grant.holder.empty())
        return Error{leitstand::fill(
            translate("leitstand::Station", "{}: another station has its drive control"), robot)};
    return line->calls().call(service, value);
}

bool Station::isOffered(const std::string& robot, const std::string& service) const {
    RobotLine* const line = m_state->line(robot);
    return line != nullptr && line->calls().isOffered(service);
}

std::vector<std::string> Station::limits() const {
    return m_state->node->warnings();
}

std::vector<SeenTopic> Station::visibleTopics() const {
    std::vector<SeenTopic> topics = seenTopics(m_state->node->endpoints(), m_state->rosNodes->nodes());
    m_state->modelWatch->complete(topics);
    return topics;
}

const FrameWatch& Station::frames() const {
    return m_state->frames;
}

TopicWatch& Station::topicWatch() {
    return *m_state->topicWatch;
}

const StationSettings& Station::settings() const {
    return m_state->settings;
}

StationBrakes& Station::brakes() {
    return *m_state->brakes;
}

StationGuards& Station::guards() {
    return *m_state->guards;
}

StationCameras& Station::cameras() {
    return *m_state->cameras;
}

JointMoving& Station::joints() {
    return *m_state->joints;
}

StationStreams& Station::streams() {
    return *m_state->streams;
}

}  // namespace leitstand
