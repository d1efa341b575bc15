#include "transport/link/robot_side.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

Time wallNow() {
    return std::chrono::system_clock::now();
}

constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();
constexpr DriveVelocity NoVelocity{NoNumber, NoNumber, NoNumber};

RobotRuleSettings rulesOf(const RobotDescription& robot, const RobotCommandSettings& settings) {
    return {.limits = limitsOf(robot),
            .watchdog = settings.watchdog,
            .grants = settings.grants,
            .standing = settings.standing,
            .firstStop = static_cast<std::uint64_t>(wallNow().time_since_epoch().count())};
}

}  // namespace

struct RobotCommands::State {
    State(const RobotDescription& description, RobotCommandSettings given)
        : settings(std::move(given)),
          robot(description),
          distance(trackDistance(description)),
          rules(description.name, rulesOf(description, settings)) {}

    Result<void> open(Node& node);
    Result<void> listen(Node& node, const StreamDescription& stream);
    void receiveGrant(const ReceivedSample& sample);
    void receive(const StreamDescription& stream, const ReceivedSample& sample);
    [[nodiscard]] DriveVelocity velocityOf(const Sample& command) const;
    /// Publishes the state of the stop. @p before changes the rules first; no other state is published in
    /// between.
    template <class Change>
    void publishAfter(Change before);
    void publishWhenItStands();

    const RobotCommandSettings settings;
    const RobotDescription robot;
    const double distance;  ///< between the tracks [m]
    StreamDescription stopState;
    std::mutex pending;  ///< states are published in order; taken before the other mutex
    std::mutex mutex;    ///< guards all that follows; never held while anything is written
    RobotRules rules;
    RobotCommandCounts counts;
    bool publishedStanding = false;
    std::unique_ptr<Publisher> publisher;
    std::vector<std::unique_ptr<Subscription>> subscriptions;  ///< last: they call back
};

template <class Change>
void RobotCommands::State::publishAfter(Change before) {
    const std::lock_guard order(pending);
    StopStateSample state;
    {
        const std::lock_guard lock(mutex);
        before();
        state = rules.stopState(steadyNow());
        publishedStanding = state.standing;
    }
    state.header = {settings.clock ? settings.clock() : wallNow(), robot.baseFrame};
    if (const auto cdr = encode(state, stopState.type)) static_cast<void>(publisher->write(*cdr));
}

void RobotCommands::State::publishWhenItStands() {
    {
        const std::lock_guard lock(mutex);
        if (rules.stopState(steadyNow()).standing == publishedStanding) return;
    }
    publishAfter([] {});
}

void RobotCommands::State::receiveGrant(const ReceivedSample& sample) {
    const auto event = decodeStationEvent(sample.event);
    const auto* grantSample = event ? event->sample.as<GrantSample>() : nullptr;
    const std::lock_guard lock(mutex);
    if (grantSample == nullptr) {
        ++counts.broken;
    } else {
        rules.receive(*grantSample, senderOf(sample.writer), steadyNow());
    }
}

DriveVelocity RobotCommands::State::velocityOf(const Sample& command) const {
    if (const auto* twist = command.as<TwistSample>()) {
        return {twist->linear.x(), twist->linear.y(), twist->angular.z()};
    }
    std::pair<double, double> tracks{NoNumber, NoNumber};  // a track without a speed does not turn
    const auto& joints = command.get<TrackCommand>();
    for (std::size_t i = 0; i < std::min(joints.names.size(), joints.velocities.size()); ++i) {
        if (joints.names[i] == settings.leftTrack) tracks.first = joints.velocities[i];
        if (joints.names[i] == settings.rightTrack) tracks.second = joints.velocities[i];
    }
    return leitstand::velocityOf(tracks, distance);
}

void RobotCommands::State::receive(const StreamDescription& stream, const ReceivedSample& sample) {
    const Sender from = senderOf(sample.writer);
    const auto decoded = decode(sample.event, stream);
    if (decoded && decoded->is<StopCommandSample>()) {
        return publishAfter([&] {
            ++counts.stops;
            static_cast<void>(rules.receive(decoded->get<StopCommandSample>(), from, steadyNow()));
        });
    }
    const std::lock_guard lock(mutex);
    if (!decoded) {
        ++counts.broken;
        // A holder whose commands cannot be read does not drive: its earlier commands are over.
        static_cast<void>(rules.drive(NoVelocity, from, steadyNow()));
        return;
    }
    const DriveVerdict verdict = rules.drive(velocityOf(*decoded), from, steadyNow());
    ++(verdict == DriveVerdict::Taken ? counts.taken : counts.refused);
}

Result<void> RobotCommands::State::listen(Node& node, const StreamDescription& stream) {
    auto made = node.subscribe({stream.topic, stream.type, stream.qos, Lane::Small},
                               [this, stream](const ReceivedSample& sample) { receive(stream, sample); });
    if (!made) return made.error();
    subscriptions.push_back(std::move(made).value());
    return {};
}

Result<void> RobotCommands::State::open(Node& node) {
    const auto need = [&](StreamRole role) -> Result<StreamDescription> {
        const StreamDescription* found = robot.stream(role);
        if (found == nullptr) {
            return Error{fmt::format("{}: expected a stream {}, found none", robot.name, toString(role))};
        }
        const auto types = typesOf(role);
        if (std::find(types.begin(), types.end(), found->type) == types.end()) {
            return Error{fmt::format("{}: {} is no type for {}", found->topic, found->type, toString(role))};
        }
        return *found;
    };
    const StreamRole role =
        robot.stream(StreamRole::DriveCommand) == nullptr && robot.stream(StreamRole::TrackCommand) != nullptr
            ? StreamRole::TrackCommand
            : StreamRole::DriveCommand;
    if (role == StreamRole::TrackCommand && distance <= 0.0) {
        return Error{
            fmt::format("{}: track_command: expected a footprint as wide as the tracks", robot.name)};
    }
    const auto drive = need(role), stop = need(StreamRole::StopCommand), state = need(StreamRole::StopState);
    for (const auto* one : {&drive, &stop, &state}) {
        if (!*one) return one->error();
    }
    stopState = *state;
    auto made = node.publisher({state->topic, state->type, state->qos, Flow::Immediate});
    if (!made) return made.error();
    publisher = std::move(made).value();
    publishAfter([] {});  // stations learn that there is somebody to stop
    const std::string grants(station_topic::Grants);
    auto heard = node.subscribe({grants, "leitstand_msgs/msg/Grant", grantQos(), Lane::Small},
                                [this](const ReceivedSample& sample) { receiveGrant(sample); });
    if (!heard) return heard.error();
    subscriptions.push_back(std::move(heard).value());
    if (auto listening = listen(node, *stop); !listening) return listening;
    return listen(node, *drive);
}

RobotCommands::RobotCommands(std::unique_ptr<State> state) : m_state(std::move(state)) {}

RobotCommands::~RobotCommands() {
    m_state->subscriptions.clear();
}

Result<std::unique_ptr<RobotCommands>> RobotCommands::create(Node& node, const RobotDescription& robot,
                                                             RobotCommandSettings settings) {
    std::unique_ptr<RobotCommands> made(
        new RobotCommands(std::make_unique<State>(robot, std::move(settings))));
    if (auto opened = made->m_state->open(node); !opened) return opened.error();
    return made;
}

DriveVelocity RobotCommands::commanded() const {
    m_state->publishWhenItStands();
    const std::lock_guard lock(m_state->mutex);
    return m_state->rules.commanded(steadyNow());
}

bool RobotCommands::isStopped() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->rules.isStopped();
}

std::string RobotCommands::holder() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->rules.grant().holder(steadyNow());
}

void RobotCommands::press() {
    m_state->publishAfter([&] { m_state->rules.press(); });
}

void RobotCommands::moved(double speed, double turnRate) {
    {
        const std::lock_guard lock(m_state->mutex);
        m_state->rules.moved(speed, turnRate, steadyNow());
    }
    m_state->publishWhenItStands();
}

RobotCommandCounts RobotCommands::counts() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->counts;
}

}  // namespace leitstand
