#include "transport/link/drive_streamer.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "core/base/time.h"
#include "transport/link/drive_message.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

/// Counts the readers of other processes; this process also reads when it records.
int othersOf(const Publisher& publisher) {
    const Sender self = senderOf(publisher.guid());
    const auto readers = publisher.readers();
    return static_cast<int>(std::count_if(readers.begin(), readers.end(),
                                          [&](const Guid& reader) { return senderOf(reader) != self; }));
}

}  // namespace

struct DriveStreamer::State {
    State(const RobotDescription& robot, DriveMessage decoded, DriveStreamerSettings given)
        : settings(std::move(given)),
          message(std::move(decoded)),
          setpoint(limitsOf(robot), settings.lifetime),
          schedule(settings.rhythm) {}

    [[nodiscard]] std::chrono::nanoseconds clockAhead() const {
        return settings.clockAhead ? settings.clockAhead() : std::chrono::nanoseconds(0);
    }
    bool send(const DriveVelocity& velocity);
    /// Notifies the guard: more commands follow, or none for now.
    void pulse(bool driving);
    /// Sends what is due; returns when to run again.
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
    const DriveMessage message;
    mutable std::mutex mutex;
    std::condition_variable_any woken;
    // Under the mutex, which is never held while anything is written:
    DriveSetpoint setpoint;
    DriveStatus status;
    bool changed = false;
    // Of the streamer's own thread:
    DriveSchedule schedule;
    bool pulsed = false;  ///< the last pulse announced more commands
    std::unique_ptr<Publisher> publisher;
    std::jthread thread;  ///< last: joined first
};

bool DriveStreamer::State::send(const DriveVelocity& velocity) {
    const auto cdr = message.encoded(velocity, clockAhead());
    const Result<void> written = cdr ? publisher->write(*cdr) : Result<void>(cdr.error());
    const int listeners = othersOf(*publisher);
    const std::lock_guard lock(mutex);
    status.listeners = listeners;
    status.velocity = velocity;
    ++(written ? status.sent : status.unsent);
    status.error = written ? std::string() : written.error().text;
    return written.ok();
}

void DriveStreamer::State::pulse(bool driving) {
    if (settings.onPulse && (driving || pulsed)) settings.onPulse({driving, clockAhead()});
    pulsed = driving;
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
    // It uses locks of others, so our own mutex is not held.
    const SightCap sight = settings.sight ? settings.sight(velocity, withoutEyes) : SightCap{};
    {
        const std::lock_guard lock(mutex);
        const SteadyTime now = steadyNow();
        const DriveVelocity sticks = setpoint.at(now);
        // Sticks or an override that were set meanwhile are judged in the next step, which follows at once.
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
        pulse(false);
        return steadyNow() + settings.rhythm.period;
    }
    const auto decision = schedule.decide(velocity, driving || conditions.hold, steadyNow());
    if (decision.send && send(velocity)) pulse(true);
    if (!decision.speaks) pulse(false);
    // A setpoint that expires becomes zero at once, not with the next repetition.
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
    m_state->pulse(false);
}

Result<std::unique_ptr<DriveStreamer>> DriveStreamer::create(Node& node, const RobotDescription& robot,
                                                             DriveStreamerSettings settings) {
    auto found = driveMessageFor(robot);
    if (!found) return found.error();
    DriveMessage message = std::move(found).value();
    message.leftTrack = settings.leftTrack;
    message.rightTrack = settings.rightTrack;
    auto state = std::make_unique<State>(robot, std::move(message), std::move(settings));
    const StreamDescription* const stream = &state->message.stream;
    // An error is better now than when the operator first pushes the stick.
    if (const auto tried = state->message.encoded({}, {}); !tried) {
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
    return othersOf(*m_state->publisher);
}

}  // namespace leitstand
