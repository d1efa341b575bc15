#include "transport/link/drive_streamer.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "transport/convert/encode.h"

namespace leitstand {
namespace {

SteadyTime steadyNow() {
    return std::chrono::steady_clock::now();
}

}  // namespace

struct DriveStreamer::State {
    State(const RobotDescription& robot, const StreamDescription& chosen, DriveStreamerSettings given)
        : settings(std::move(given)),
          stream(chosen),
          frame(robot.baseFrame),
          distance(trackDistance(robot)),
          setpoint(limitsOf(robot), settings.lifetime),
          schedule(settings.rhythm) {}

    [[nodiscard]] Sample sampleOf(const DriveVelocity& velocity) const;
    void send(const DriveVelocity& velocity);
    /// Sends what is due; when to come again.
    SteadyTime step();
    void run(const std::stop_token& stop);
    template <class Change>
    void change(Change doIt) {
        {
            const std::lock_guard lock(mutex);
            doIt();
            changed = true;
        }
        woken.notify_all();
    }

    const DriveStreamerSettings settings;
    const StreamDescription stream;
    const std::string frame;
    const double distance;  ///< between the tracks [m]
    mutable std::mutex mutex;
    std::condition_variable_any woken;
    // Under the mutex, which is never held while anything is written:
    DriveSetpoint setpoint;
    DriveStatus status;
    bool changed = false;
    // Of the streamer's own thread:
    DriveSchedule schedule;
    std::unique_ptr<Publisher> publisher;
    std::jthread thread;  ///< last: joined first
};

Sample DriveStreamer::State::sampleOf(const DriveVelocity& velocity) const {
    const Time now = std::chrono::system_clock::now();
    const auto ahead = settings.clockAhead ? settings.clockAhead() : std::chrono::nanoseconds(0);
    const std::optional<Time> stamp = commandStamp(stream.stamp, now, ahead);
    if (stream.role == StreamRole::TrackCommand) {
        const auto [left, right] = tracksOf(velocity, distance);
        TrackCommand command;
        command.header = {stamp.value_or(Time{}), frame};
        command.names = {settings.leftTrack, settings.rightTrack};
        command.velocities = {left, right};
        return command;
    }
    TwistSample command;
    command.stamp = stamp;
    command.frame = frame;
    command.linear = {velocity.forward, velocity.left, 0.0};
    command.angular = {0.0, 0.0, velocity.turn};
    return command;
}

void DriveStreamer::State::send(const DriveVelocity& velocity) {
    const auto cdr = encode(sampleOf(velocity), stream.type);
    const Result<void> written = cdr ? publisher->write(*cdr) : Result<void>(cdr.error());
    const int listeners = publisher->matched();
    const std::lock_guard lock(mutex);
    status.listeners = listeners;
    status.velocity = velocity;
    ++(written ? status.sent : status.unsent);
    status.error = written ? std::string() : written.error().text;
}

SteadyTime DriveStreamer::State::step() {
    const DriveConditions conditions = settings.conditions ? settings.conditions() : DriveConditions{};
    DriveVelocity velocity;
    bool driving = false, withoutEyes = false;
    SteadyTime expires;
    {
        const std::lock_guard lock(mutex);
        setpoint.permit(status.focus && conditions.mayDrive && !conditions.hold);
        velocity = setpoint.at(steadyNow());
        withoutEyes = setpoint.withoutEyes(steadyNow());
    }
    // It looks at what others have locked: not under our own mutex.
    const SightCap sight = settings.sight ? settings.sight(velocity, withoutEyes) : SightCap{};
    {
        const std::lock_guard lock(mutex);
        const SteadyTime now = steadyNow();
        const DriveVelocity sticks = setpoint.at(now);
        // Sticks told meanwhile, with the override perhaps, are judged in the next step, which comes at once.
        const bool judged = sticks == velocity && setpoint.withoutEyes(now) == withoutEyes;
        if (sight.factor <= 0.0 && !isZero(sticks) && judged) setpoint.halt();
        velocity = capped(sticks, sight, setpoint.limits());
        status.sight = sight;
        driving = setpoint.isFresh(now);
        expires = setpoint.expires();
        status.driving = driving;
        status.needsNeutral = setpoint.waitsForNeutral();
    }
    if (conditions.silent && conditions.mayDrive && !conditions.hold) {
        return steadyNow() + settings.rhythm.period;
    }
    const auto decision = schedule.decide(velocity, driving || conditions.hold, steadyNow());
    if (decision.send) send(velocity);
    // What grows too old becomes zero then, not with the next repetition.
    return driving ? std::min(decision.next, expires) : decision.next;
}

void DriveStreamer::State::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "drive");
    while (!stop.stop_requested()) {
        const SteadyTime next = step();
        std::unique_lock lock(mutex);
        woken.wait_until(lock, stop, next, [this] { return changed; });
        changed = false;
    }
}

DriveStreamer::DriveStreamer(std::unique_ptr<State> state) : m_state(std::move(state)) {}

DriveStreamer::~DriveStreamer() {
    m_state->thread.request_stop();
    if (m_state->thread.joinable()) m_state->thread.join();
    if (!isZero(m_state->status.velocity)) m_state->send({});
}

Result<std::unique_ptr<DriveStreamer>> DriveStreamer::create(Node& node, const RobotDescription& robot,
                                                             DriveStreamerSettings settings) {
    const StreamDescription* stream = robot.stream(StreamRole::DriveCommand);
    if (stream == nullptr) stream = robot.stream(StreamRole::TrackCommand);
    if (stream == nullptr) {
        return Error{
            fmt::format("{}: expected a stream drive_command or track_command, found neither", robot.name)};
    }
    if (stream->role == StreamRole::TrackCommand && trackDistance(robot) <= 0.0) {
        return Error{
            fmt::format("{}: track_command: expected a footprint that is as wide as its tracks", robot.name)};
    }
    auto state = std::make_unique<State>(robot, *stream, std::move(settings));
    // Better now than when the operator first pushes the stick.
    if (const auto tried = encode(state->sampleOf({}), stream->type); !tried) {
        return Error{fmt::format("{}: {}", stream->topic, tried.error().text)};
    }
    auto publisher = node.publisher({stream->topic, stream->type, stream->qos, Flow::Immediate});
    if (!publisher) return publisher.error();
    state->publisher = std::move(publisher).value();
    state->thread = std::jthread([self = state.get()](const std::stop_token& stop) { self->run(stop); });
    return std::unique_ptr<DriveStreamer>(new DriveStreamer(std::move(state)));
}

void DriveStreamer::set(const DriveVelocity& velocity, bool withoutEyes) {
    const SteadyTime now = steadyNow();
    m_state->change([&] { m_state->setpoint.set(velocity, now, withoutEyes); });
}

void DriveStreamer::halt() {
    m_state->change([&] { m_state->setpoint.halt(); });
}

void DriveStreamer::setFocus(bool focus) {
    m_state->change([&] {
        m_state->status.focus = focus;
        if (!focus) m_state->setpoint.permit(false);
    });
}

void DriveStreamer::refresh() {
    m_state->change([] {});
}

DriveStatus DriveStreamer::status() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->status;
}

int DriveStreamer::listeners() const {
    return m_state->publisher->matched();
}

}  // namespace leitstand
