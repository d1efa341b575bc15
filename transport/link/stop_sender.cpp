#include "transport/link/stop_sender.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <pthread.h>

#include "core/base/time.h"
#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/link/stop_services.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;

/// Clears what changes by itself all the time: it is no news.
StopStatus reported(StopStatus status) {
    status.unanswered = {};
    return status;
}

/// When a lock is set and freed. A multiplexer may forget a lock that is not set again and again, so it is
/// repeated. Freeing it is repeated a few times, since a message may be lost. Then it is somebody else's.
class LockPulse {
public:
    /// Returns what must be written now; empty: nothing.
    [[nodiscard]] std::optional<DriveLockSample> due(bool wanted, SteadyTime now) {
        if (wanted) m_toFree = Frees;
        if (std::exchange(m_locked, wanted) != wanted) m_next = now;
        if (now < m_next || (!wanted && m_toFree == 0)) return std::nullopt;
        m_next = now + Period;
        if (!wanted) --m_toFree;
        return DriveLockSample{wanted};
    }

private:
    static constexpr int Frees = 5;
    static constexpr milliseconds Period{100};
    bool m_locked = false;
    int m_toFree = 0;
    SteadyTime m_next = {};
};

}  // namespace

struct StopSender::State {
    struct Robot {
        StreamDescription command = {}, state = {}, odometry = {};
        StopControl control;
        std::unique_ptr<Publisher> publisher = {};
        std::string lockType = {};
        std::unique_ptr<Publisher> lock = {};  ///< null: the robot has none
        LockPulse pulse = {};                  ///< of the sender's own thread
        bool lockHeard = false;
        StopStatus reported = {};  ///< of the sender's own thread
        std::vector<std::unique_ptr<Subscription>> subscriptions = {};
        std::unique_ptr<StopServices> services = {};

        [[nodiscard]] StopStatus status() const {
            StopStatus all = control.status(steadyNow());
            all.locks = lock != nullptr;
            all.lockHeard = lockHeard;
            if (services) {
                all.services = services->status();
                if (all.refused.empty()) all.refused = services->refusal();
                all.releasing = all.releasing || services->isReleasing();
            }
            return all;
        }
    };
    using Robots = std::map<std::string, Robot>;

    explicit State(StopSenderSettings given) : settings(std::move(given)) {}

    Result<void> add(Node& node, const RobotDescription& description);
    /// Calls @p doIt with @p robot; does nothing when it is unknown.
    template <class Change>
    void change(const std::string& robot, Change doIt) {
        {
            const std::lock_guard lock(mutex);
            const auto found = robots.find(robot);
            if (found == robots.end()) return;
            doIt(found->second);
            changed = true;
        }
        woken.notify_all();
    }
    void wake() {
        {
            const std::lock_guard lock(mutex);
            changed = true;
        }
        woken.notify_all();
    }
    /// Under the mutex.
    static void stop(Robot& robot) {
        robot.control.stop(steadyNow(), std::chrono::system_clock::now());
        if (robot.services) robot.services->stop(steadyNow());
    }
    template <class Question>
    auto ask(const std::string& robot, Question question) const {
        const std::lock_guard lock(mutex);
        const auto found = robots.find(robot);
        using Answer = decltype(question(found->second));
        return found == robots.end() ? Answer{} : question(found->second);
    }
    void receive(const std::string& robot, const StreamDescription& stream, const ReceivedSample& sample);
    void step();
    void run(const std::stop_token& stop);

    const StopSenderSettings settings;
    mutable std::mutex mutex;  ///< guards the controls; never held while anything is written
    std::condition_variable_any woken;
    Robots robots;  ///< the map itself does not change once the thread runs
    bool changed = false;
    std::jthread thread;  ///< last: joined first
};

void StopSender::State::receive(const std::string& robot, const StreamDescription& stream,
                                const ReceivedSample& sample) {
    const auto decoded = decode(sample.event, stream);
    if (!decoded) return;
    if (const auto* state = decoded->as<StopStateSample>()) {
        change(robot, [&](Robot& one) { one.control.receive(*state); });
    } else if (const auto* odometry = decoded->as<OdometrySample>()) {
        // Reported with the next tick: the thread is not woken 50 times a second for it.
        const std::lock_guard lock(mutex);
        robots.at(robot).control.moved(odometry->linear.norm(), odometry->angular.norm(), steadyNow());
    }
}

Result<void> StopSender::State::add(Node& node, const RobotDescription& description) {
    const StreamDescription* command = description.stream(StreamRole::StopCommand);
    const auto made = [&] {
        const std::lock_guard lock(mutex);  // samples of the robots before it already arrive
        return robots.try_emplace(
            description.name,
            Robot{.control = StopControl(settings.station, command != nullptr, settings.timing)});
    }();
    if (!made.second) return Error{fmt::format("{}: the name of two robots", description.name)};
    Robot& robot = made.first->second;
    const auto listen = [&](StreamRole role, StreamDescription& to) -> Result<void> {
        const StreamDescription* found = description.stream(role);
        if (found == nullptr) return {};
        to = *found;
        auto subscribed =
            node.subscribe({to.topic, to.type, to.qos, Lane::Small},
                           [this, name = description.name, stream = to](const ReceivedSample& sample) {
                               receive(name, stream, sample);
                           });
        if (!subscribed) return subscribed.error();
        robot.subscriptions.push_back(std::move(subscribed).value());
        return {};
    };
    if (const StreamDescription* const lock = description.stream(StreamRole::StopLock)) {
        if (const auto tried = encode(DriveLockSample{}, lock->type); !tried)
            return Error{fmt::format("{}: {}", lock->topic, tried.error().text)};
        robot.lockType = lock->type;
        auto writer = node.publisher({lock->topic, lock->type, lock->qos, Flow::Immediate});
        if (!writer) return writer.error();
        robot.lock = std::move(writer).value();
    }
    if (command != nullptr) {
        robot.command = *command;
        if (const auto tried = encode(StopCommandSample{{}, settings.station, 1, true, 0}, command->type);
            !tried) {
            return Error{fmt::format("{}: {}", command->topic, tried.error().text)};
        }
        Qos qos = command->qos;
        qos.lifespan = 0.0;  // a stop never expires, whatever the robot's file contains
        auto writer = node.publisher({command->topic, command->type, qos, Flow::Immediate});
        if (!writer) return writer.error();
        robot.publisher = std::move(writer).value();
        if (auto subscribed = listen(StreamRole::StopState, robot.state); !subscribed) return subscribed;
    }
    if (auto subscribed = listen(StreamRole::Odometry, robot.odometry); !subscribed) return subscribed;
    auto services = StopServices::create(node, description, [this] { wake(); });
    const std::lock_guard lock(mutex);
    robot.services = std::move(services);
    return {};
}

void StopSender::State::step() {
    for (auto& [name, robot] : robots) {
        std::optional<StopCommandSample> command;
        StopStatus status;
        bool wanted = false;
        const bool lockHeard = robot.lock && robot.lock->matched() > 0;
        {
            const std::lock_guard lock(mutex);
            command = robot.control.due(steadyNow(), std::chrono::system_clock::now());
            wanted = robot.control.isWanted();
            if (wanted && !robot.control.isWaiting()) robot.services->hold(steadyNow());
            robot.lockHeard = lockHeard;
            status = reported(robot.status());
        }
        if (command && robot.publisher) {
            // What is not written now is written with the next repetition.
            if (const auto cdr = encode(*command, robot.command.type))
                static_cast<void>(robot.publisher->write(*cdr));
        }
        if (const auto lock = robot.lock ? robot.pulse.due(wanted, steadyNow()) : std::nullopt) {
            if (const auto cdr = encode(*lock, robot.lockType)) static_cast<void>(robot.lock->write(*cdr));
        }
        if (robot.services->step(steadyNow())) {
            // One service did not release: the rest is stopped again, too.
            const std::lock_guard lock(mutex);
            robot.control.stop(steadyNow(), std::chrono::system_clock::now());
            robot.services->hold(steadyNow());
        }
        if (std::exchange(robot.reported, status) != status && settings.onChange) settings.onChange(name);
    }
}

void StopSender::State::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "stop");
    while (!stop.stop_requested()) {
        step();
        std::unique_lock lock(mutex);
        woken.wait_for(lock, stop, milliseconds(20), [this] { return changed; });
        changed = false;
    }
}

StopSender::StopSender(std::unique_ptr<State> state) : m_state(std::move(state)) {}

StopSender::~StopSender() {
    m_state->thread.request_stop();
    if (m_state->thread.joinable()) m_state->thread.join();
    for (auto& [name, robot] : m_state->robots) {
        robot.subscriptions.clear();
        robot.services.reset();
    }
}

Result<std::unique_ptr<StopSender>> StopSender::create(Node& node, std::span<const RobotDescription> robots,
                                                       StopSenderSettings settings) {
    std::unique_ptr<StopSender> sender(new StopSender(std::make_unique<State>(std::move(settings))));
    State& state = *sender->m_state;
    for (const RobotDescription& robot : robots) {
        if (auto added = state.add(node, robot); !added) return added.error();
    }
    state.thread = std::jthread([&state](const std::stop_token& stop) { state.run(stop); });
    return sender;
}

void StopSender::stopAll() {
    for (const auto& [name, robot] : m_state->robots) stop(name);
}

void StopSender::stop(const std::string& robot) {
    m_state->change(robot, [](State::Robot& one) { State::stop(one); });
}

Result<void> StopSender::release(const std::string& robot) {
    const bool held = m_state->settings.mayRelease && m_state->settings.mayRelease(robot);
    Result<void> result = Error{fmt::format("release: no robot is called \"{}\"", robot)};
    m_state->change(robot, [&](State::Robot& one) {
        result = one.control.release(held, steadyNow(), std::chrono::system_clock::now());
        if (result && one.services) one.services->release(steadyNow());
    });
    return result;
}

StopStatus StopSender::status(const std::string& robot) const {
    return m_state->ask(robot, [](const State::Robot& one) { return one.status(); });
}

bool StopSender::allowsDriving(const std::string& robot) const {
    return m_state->ask(robot, [](const State::Robot& one) {
        return one.control.allowsDriving() && !(one.services && one.services->isReleasing());
    });
}

bool StopSender::holdsByZeros(const std::string& robot) const {
    return m_state->ask(robot, [](const State::Robot& one) { return one.control.holdsByZeros(); });
}

}  // namespace leitstand
