#include "transport/link/drive_guard.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

#include <poll.h>
#include <sys/socket.h>

#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "transport/convert/decode.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds LooksForRobot(100);  ///< period of checks that the robot still hears it
constexpr std::chrono::milliseconds RepeatsAfter(500);

SteadyTime moment() {
    return std::chrono::steady_clock::now();
}

/// Waits until @p pipe has something to read, at most @p atMost. Without @p open, only waits for that time.
void waitFor(int pipe, bool open, std::chrono::nanoseconds atMost) {
    const auto ns = std::max(atMost, std::chrono::nanoseconds(0)).count();
    const timespec patience{ns / 1'000'000'000, ns % 1'000'000'000};
    pollfd polled{pipe, POLLIN, 0};
    ppoll(&polled, open ? 1 : 0, &patience, nullptr);
}

}  // namespace

struct DriveGuard::State {
    State(Node& domain, DriveGuardSettings given)
        : node(domain),
          settings(std::move(given)),
          drivers{settings.driver},
          rules(settings.robot, settings.station, settings.timing) {}

    Result<void> open();
    [[nodiscard]] bool isReceived() const;
    /// Notifies the station whether the robot hears the guard, on change and periodically.
    void notify(int pipe, bool heard, SteadyTime now);
    /// Reads all that came through @p pipe; returns whether its other end is still open.
    bool read(int pipe);

    Node& node;
    const DriveGuardSettings settings;
    std::optional<bool> reported;  ///< last notification: whether the robot hears the guard
    SteadyTime notifiedAt = {};
    std::mutex mutex;
    // Under the mutex:
    bool piped = true;         ///< the pipe is open
    std::set<Sender> drivers;  ///< participants that the station is, or was
    GuardRules rules;
    std::unique_ptr<Publisher> publisher;
    std::unique_ptr<Subscription> commands, grants;  ///< last: they call back
};

Result<void> DriveGuard::State::open() {
    const StreamDescription& stream = settings.message.stream;
    if (const auto tried = settings.message.encoded({}, {}); !tried) return tried.error();
    auto made = node.publisher({stream.topic, stream.type, stream.qos, Flow::Immediate});
    if (!made) return made.error();
    publisher = std::move(made).value();
    const Sender self = senderOf(node.guid());
    // Receives others' commands whatever QoS they offer.
    const Qos any{.reliability = Qos::Reliability::BestEffort, .depth = 10};
    auto heard = node.subscribe({stream.topic, stream.type, any, Lane::Small},
                                [this, self](const ReceivedSample& sample) {
                                    const Sender from = senderOf(sample.writer);
                                    const std::lock_guard lock(mutex);
                                    if (from != self && !drivers.contains(from)) rules.commanded(moment());
                                });
    if (!heard) return heard.error();
    commands = std::move(heard).value();
    auto held = node.subscribe(
        {std::string(station_topic::Grants), "leitstand_msgs/msg/Grant", grantQos(), Lane::Small},
        [this](const ReceivedSample& sample) {
            const auto event = decodeStationEvent(sample.event);
            const auto* grant = event ? event->sample.as<GrantSample>() : nullptr;
            if (grant == nullptr) return;
            const std::lock_guard lock(mutex);
            // The station has joined the domain again, as another participant. A restarted station is another
            // driver: the pipe of the one before is closed.
            if (piped && grant->station == settings.station) drivers.insert(senderOf(sample.writer));
            rules.receive(*grant, senderOf(sample.writer), moment());
        });
    if (!held) return held.error();
    grants = std::move(held).value();
    return {};
}

/// A reader of the commands is the robot's unless it belongs to a recording station (known by its grants) or
/// to another guard.
bool DriveGuard::State::isReceived() const {
    const auto readers = publisher->readers();
    const auto endpoints = node.endpoints();
    std::set<Sender> others = {senderOf(node.guid()), settings.driver};
    for (const RemoteEndpoint& one : endpoints) {
        const bool grants = one.kind == RemoteEndpoint::Kind::Writer && one.topic == station_topic::Grants;
        if (grants || one.participantName == settings.ownName) others.insert(senderOf(one.guid));
    }
    return std::any_of(readers.begin(), readers.end(),
                       [&](const Guid& reader) { return !others.contains(senderOf(reader)); });
}

void DriveGuard::State::notify(int pipe, bool heard, SteadyTime now) {
    if (reported == heard && now - notifiedAt < RepeatsAfter) return;
    const std::string_view word = heard ? guard_word::Ready : guard_word::Waits;
    static_cast<void>(send(pipe, word.data(), word.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
    reported = heard;
    notifiedAt = now;
}

bool DriveGuard::State::read(int pipe) {
    std::array<char, 64> text{};
    for (;;) {
        const ssize_t size = recv(pipe, text.data(), text.size(), MSG_DONTWAIT);
        if (size == 0) return false;
        if (size < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
        const auto pulse = guardPulseFrom({text.data(), static_cast<std::size_t>(size)});
        const std::lock_guard lock(mutex);
        if (pulse) rules.pulse(*pulse, moment());  // an invalid pulse counts as silence
    }
}

DriveGuard::DriveGuard(std::unique_ptr<State> state) : m_state(std::move(state)) {}

DriveGuard::~DriveGuard() {
    m_state->commands.reset();
    m_state->grants.reset();
}

Result<std::unique_ptr<DriveGuard>> DriveGuard::create(Node& node, DriveGuardSettings settings) {
    auto state = std::make_unique<State>(node, std::move(settings));
    if (auto opened = state->open(); !opened) return opened.error();
    return std::unique_ptr<DriveGuard>(new DriveGuard(std::move(state)));
}

void DriveGuard::serve(int pipe) {
    SteadyTime looks = {};
    for (bool open = true;;) {
        if (open && !m_state->read(pipe)) {
            open = false;
            const std::lock_guard lock(m_state->mutex);
            m_state->piped = false;
            m_state->rules.closed();
        }
        GuardRules::Step step;
        std::chrono::nanoseconds ahead;
        {
            const std::lock_guard lock(m_state->mutex);
            step = m_state->rules.step(moment());
            ahead = m_state->rules.clockAhead();
        }
        if (step.zero) {
            if (const auto zero = m_state->settings.message.encoded({}, ahead))
                static_cast<void>(m_state->publisher->write(*zero));
        }
        if (step.over) return;
        const SteadyTime now = moment();
        if (open && now >= looks) {
            looks = now + LooksForRobot;
            m_state->notify(pipe, m_state->isReceived(), now);
        }
        waitFor(pipe, open, std::min(step.next.value_or(now + LooksForRobot), now + LooksForRobot) - now);
    }
}

}  // namespace leitstand
