#include "transport/link/link_client.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "core/event/command_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// Returns when a sample that has just been handed over was received, on the steady clock.
SteadyTime receivedAt(Time received) {
    const nanoseconds since = std::chrono::system_clock::now() - received;
    return std::chrono::steady_clock::now() -
           std::clamp<nanoseconds>(since, nanoseconds(0), std::chrono::seconds(1));
}

StreamArrival arrivalOf(const ReceivedSample& sample) {
    return {sample.event.cdr ? sample.event.cdr->size() : 0, sample.writer.bytes, sample.writerSequence,
            sample.sourceTime, sample.event.received};
}

/// Returns whether @p now differs enough from the last logged status to be logged.
bool isNews(const ClockStatus& before, const ClockStatus& now) {
    const auto moved = std::chrono::abs(now.ahead - before.ahead);
    const auto bounds =
        std::max<nanoseconds>(std::min(before.uncertainty, now.uncertainty) / 4, milliseconds(1));
    return now.steps != before.steps || now.source != before.source || moved > bounds ||
           2 * now.uncertainty < before.uncertainty || now.uncertainty > 2 * before.uncertainty;
}

}  // namespace

struct LinkClient::State {
    State(const RobotDescription& robot, LinkClientSettings chosen, LinkListener before)
        : settings(std::move(chosen)), listener(std::move(before)), monitor(robot, settings.rules) {
        if (const StreamDescription* found = robot.stream(StreamRole::Ping)) ping = *found;
        if (const StreamDescription* found = robot.stream(StreamRole::Pong)) pong = *found;
    }

    void sendPing();
    void takePong(const ReceivedSample& sample);
    void notify();
    void run(const std::stop_token& stop);

    const LinkClientSettings settings;
    const LinkListener listener;
    std::optional<StreamDescription> ping, pong;
    mutable std::mutex mutex;
    LinkMonitor monitor;  ///< under the mutex
    std::atomic<std::uint64_t> broken = 0;
    // Of the client's own thread:
    std::uint64_t number = 0;
    LinkState state = LinkState::NeverSeen;
    std::optional<ClockStatus> clock;  ///< as logged last
    SteadyTime clockPublished;
    std::unique_ptr<Publisher> pings;
    std::unique_ptr<Subscription> pongs;
    std::jthread thread;  ///< last: joined first
};

void LinkClient::State::sendPing() {
    if (!pings || pings->matched() == 0) return;
    PingSample sample;
    sample.number = ++number;
    sample.station = settings.station;
    sample.sent = std::chrono::system_clock::now();
    {
        const std::lock_guard lock(mutex);  // before it goes out: the answer may be quick
        monitor.ping(sample.number, sample.sent, std::chrono::steady_clock::now());
    }
    const auto cdr = encode(sample, ping->type);
    if (!cdr || !pings->write(*cdr)) return;
    if (listener.onPing) listener.onPing({0, sample.sent, ping->topic, ping->type, *cdr});
}

void LinkClient::State::takePong(const ReceivedSample& sample) {
    const SteadyTime now = receivedAt(sample.event.received);
    const auto decoded = decode(sample.event, *pong);
    const auto* answer = decoded ? decoded->as<PongSample>() : nullptr;
    if (answer == nullptr) ++broken;
    {
        const std::lock_guard lock(mutex);
        monitor.sample(sample.event.topic, arrivalOf(sample), now);
        if (answer != nullptr && answer->station == settings.station)
            monitor.pong(*answer, sample.event.received, now);
    }
    if (listener.onPong) listener.onPong(sample);
}

void LinkClient::State::notify() {
    LinkStatus status;
    {
        const std::lock_guard lock(mutex);
        status = monitor.status(std::chrono::steady_clock::now());
    }
    const auto now = std::chrono::steady_clock::now();
    if (std::exchange(state, status.state) != status.state && listener.onState) listener.onState(status);
    if (listener.onStatus) listener.onStatus(status);
    if (!listener.onClockOffset || !status.clock) return;
    if (clock && (now - clockPublished < std::chrono::seconds(1) || !isNews(*clock, *status.clock))) return;
    clock = status.clock;
    clockPublished = now;
    listener.onClockOffset(*clockOffsetOf(status, std::chrono::system_clock::now()));
}

void LinkClient::State::run(const std::stop_token& stop) {
    std::mutex idle;
    std::condition_variable_any woken;
    auto nextPing = std::chrono::steady_clock::now(), nextStatus = nextPing;
    const bool pinging = pings && settings.pingEvery > milliseconds(0);
    while (!stop.stop_requested()) {
        const auto now = std::chrono::steady_clock::now();
        if (pinging && now >= nextPing) {
            sendPing();
            nextPing = std::max(nextPing + settings.pingEvery, now);
        }
        if (now >= nextStatus) {
            notify();
            nextStatus = std::max(nextStatus + settings.statusEvery, now);
        }
        std::unique_lock lock(idle);
        woken.wait_until(lock, stop, pinging ? std::min(nextPing, nextStatus) : nextStatus,
                         [] { return false; });
    }
}

LinkClient::LinkClient(std::unique_ptr<State> state) : m_state(std::move(state)) {}

LinkClient::~LinkClient() {
    m_state->thread.request_stop();
    if (m_state->thread.joinable()) m_state->thread.join();
    m_state->pongs.reset();  // its callback uses the rest
}

Result<std::unique_ptr<LinkClient>> LinkClient::create(Node& node, const RobotDescription& robot,
                                                       const LinkClientSettings& settings,
                                                       LinkListener listener) {
    auto state = std::make_unique<State>(robot, settings, std::move(listener));
    State& its = *state;
    if (its.ping && its.pong && settings.pingEvery > milliseconds(0)) {
        if (const auto test = encode(PingSample{}, its.ping->type); !test)
            return Error{its.ping->topic + ": " + test.error().text};
        auto pings = node.publisher({its.ping->topic, its.ping->type, its.ping->qos, Flow::Immediate});
        if (!pings) return pings.error();
        its.pings = std::move(pings).value();
        // numbers rise over restarts of the station, too
        its.number = static_cast<std::uint64_t>(
            std::chrono::floor<milliseconds>(std::chrono::system_clock::now().time_since_epoch()).count());
    }
    if (its.pong) {
        auto pongs = node.subscribe({its.pong->topic, its.pong->type, its.pong->qos, Lane::Small},
                                    [&its](const ReceivedSample& sample) { its.takePong(sample); });
        if (!pongs) return pongs.error();
        its.pongs = std::move(pongs).value();
    }
    its.thread = std::jthread([&its](const std::stop_token& stop) { its.run(stop); });
    return std::unique_ptr<LinkClient>(new LinkClient(std::move(state)));
}

void LinkClient::onSample(const ReceivedSample& sample) {
    if (m_state->pong && sample.event.topic == m_state->pong->topic) return;
    const SteadyTime now = receivedAt(sample.event.received);
    const std::lock_guard lock(m_state->mutex);
    m_state->monitor.sample(sample.event.topic, arrivalOf(sample), now);
}

void LinkClient::setPaused(std::string_view topic, bool paused) {
    const std::lock_guard lock(m_state->mutex);
    m_state->monitor.setPaused(topic, paused, std::chrono::steady_clock::now());
}

LinkStatus LinkClient::status() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->monitor.status(std::chrono::steady_clock::now());
}

std::uint64_t LinkClient::brokenPongs() const {
    return m_state->broken;
}

}  // namespace leitstand
