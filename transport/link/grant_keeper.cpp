#include "transport/link/grant_keeper.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/time.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

constexpr auto Tick = std::chrono::milliseconds(50);
constexpr const char* GrantType = "leitstand_msgs/msg/Grant";

}  // namespace

Qos grantQos() {
    return {.durability = Qos::Durability::TransientLocal, .depth = 32};
}

struct GrantKeeper::State {
    State(const StationIdentity& me, const Sender& sender, GrantListener notify, const GrantTiming& timing)
        : listener(std::move(notify)), book(me, sender, steadyNow(), timing), remembered(book.held()) {}

    using Views = std::map<GrantId, std::pair<GrantView, bool>>;

    template <class Change>
    void change(Change doIt) {
        {
            const std::lock_guard lock(mutex);
            doIt(book, steadyNow());
            changed = true;
        }
        woken.notify_all();
    }
    void receive(const ReceivedSample& sample) {
        const auto event = decodeStationEvent(sample.event);
        if (!event) return;
        if (const auto* decoded = event->sample.as<GrantSample>()) {
            change(
                [&](GrantBook& one, SteadyTime now) { one.receive(*decoded, senderOf(sample.writer), now); });
        }
    }
    void send(const std::vector<GrantSample>& samples) const {
        for (const GrantSample& sample : samples) {
            // A write fails only when the node has left; nobody misses heartbeats then.
            if (const auto cdr = encode(sample, GrantType)) static_cast<void>(publisher->write(*cdr));
        }
    }
    void notify(const Views& now, std::vector<HeldGrant> held) {
        const bool news = std::exchange(views, now) != now;
        if (held != remembered) {
            remembered = held;
            if (listener.onHeld) listener.onHeld(std::move(held));
        }
        if (news && listener.onChange) listener.onChange();
    }
    void run(const std::stop_token& stop);

    const GrantListener listener;
    mutable std::mutex mutex;
    std::condition_variable_any woken;
    GrantBook book;        ///< under the mutex
    bool changed = false;  ///< under the mutex
    // Of the keeper's own thread:
    Views views;
    std::vector<HeldGrant> remembered;
    std::unique_ptr<Publisher> publisher;
    std::unique_ptr<Subscription> subscription;
    std::jthread thread;  ///< last: joined first
};

void GrantKeeper::State::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::vector<GrantSample> samples;
        Views now;
        std::vector<HeldGrant> held;
        {
            const std::lock_guard lock(mutex);
            samples = book.due(steadyNow(), std::chrono::system_clock::now());
            for (const GrantId& id : book.known()) {
                now[id] = {book.view(id, steadyNow()), book.mayAct(id, steadyNow())};
            }
            held = book.held();
        }
        send(samples);
        notify(now, std::move(held));
        std::unique_lock lock(mutex);
        woken.wait_for(lock, stop, Tick, [this] { return changed; });
        changed = false;
    }
}

GrantKeeper::GrantKeeper(std::unique_ptr<State> state) : m_state(std::move(state)) {}

GrantKeeper::~GrantKeeper() {
    m_state->thread.request_stop();
    if (m_state->thread.joinable()) m_state->thread.join();
    m_state->subscription.reset();
    m_state->book.leave(steadyNow());
    m_state->send(m_state->book.due(steadyNow(), std::chrono::system_clock::now()));
    // A node that goes at once takes unsent samples with it.
    static_cast<void>(m_state->publisher->waitForAcknowledgments(std::chrono::milliseconds(200)));
}

Result<std::unique_ptr<GrantKeeper>> GrantKeeper::create(Node& node, const StationIdentity& me,
                                                         GrantListener listener, const GrantTiming& timing) {
    if (me.id.empty()) return Error{"grants: expected the identity of the station, found an empty one"};
    auto state = std::make_unique<State>(me, senderOf(node.guid()), std::move(listener), timing);
    const std::string topic(station_topic::Grants);
    auto publisher = node.publisher({topic, GrantType, grantQos(), Flow::Immediate});
    if (!publisher) return publisher.error();
    state->publisher = std::move(publisher).value();
    auto subscription =
        node.subscribe({topic, GrantType, grantQos(), Lane::Small},
                       [self = state.get()](const ReceivedSample& sample) { self->receive(sample); });
    if (!subscription) return subscription.error();
    state->subscription = std::move(subscription).value();
    state->thread = std::jthread([self = state.get()](const std::stop_token& stop) { self->run(stop); });
    return std::unique_ptr<GrantKeeper>(new GrantKeeper(std::move(state)));
}

void GrantKeeper::rejoined(const Guid& participant) {
    m_state->change([&](GrantBook& book, SteadyTime) { book.rejoined(senderOf(participant)); });
}

void GrantKeeper::requestGrant(const GrantId& id) {
    m_state->change([&](GrantBook& book, SteadyTime) { book.requestGrant(id); });
}

void GrantKeeper::release(const GrantId& id) {
    m_state->change([&](GrantBook& book, SteadyTime now) { book.release(id, now); });
}

void GrantKeeper::answerRequest(const GrantId& id, bool consent) {
    m_state->change([&](GrantBook& book, SteadyTime now) { book.answerRequest(id, consent, now); });
}

GrantView GrantKeeper::view(const GrantId& id) const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->book.view(id, steadyNow());
}

bool GrantKeeper::mayAct(const GrantId& id) const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->book.mayAct(id, steadyNow());
}

std::vector<HeldGrant> GrantKeeper::held() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->book.held();
}

}  // namespace leitstand
