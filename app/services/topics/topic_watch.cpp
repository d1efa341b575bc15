#include "app/services/topics/topic_watch.h"

#include <algorithm>

#include "core/base/words.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Window(5);
constexpr std::size_t MostReceived = 20'000, MostNumbers = 6'000;
constexpr std::size_t LargestPlotted = 65'536;  ///< larger messages are read only to be shown [B]

double secondsOf(SteadyTime::duration time) {
    return std::chrono::duration<double>(time).count();
}

}  // namespace

Result<void> TopicWatch::watch(const SeenTopic& topic) {
    auto watched = std::make_shared<Watched>();
    watched->topic = topic.name;
    watched->type = topic.type;
    watched->seen = topic;
    m_types.forgetFailures();
    end();
    if (!topic.obstacle.empty()) {
        // Our reader would match nobody, and count as a mismatch of the station.
        watched->problem = topic.obstacle;
        watched->hindered = true;
        const std::scoped_lock lock(m_mutex);
        m_watched = std::move(watched);
        return {};
    }
    // Best effort loads a bad link least; only what was said before is asked for reliably.
    ReaderSettings reader{topic.name, topic.type, topic.qos, Lane::Large};
    const bool stays = topic.written && topic.qos.durability == Qos::Durability::TransientLocal;
    if (!stays) reader.qos.durability = Qos::Durability::Volatile;
    if (!stays) reader.qos.reliability = Qos::Reliability::BestEffort;
    reader.qos.lifespan = reader.qos.deadline = 0.0;
    reader.qos.depth = 1;
    auto made = m_node.subscribe(reader, [watched](const ReceivedSample& sample) { take(*watched, sample); });
    if (!made) return made.error();
    const std::scoped_lock lock(m_mutex);
    m_watched = std::move(watched);
    m_subscription = std::move(made).value();
    return {};
}

void TopicWatch::learn(Watched& watched) const {
    SeenTopic seen;
    {
        const std::scoped_lock lock(watched.mutex);
        if (watched.text || watched.hindered) return;
        seen = watched.seen;
    }
    const auto text = m_types.text(seen);
    const std::scoped_lock lock(watched.mutex);
    watched.problem.clear();
    if (!text)
        watched.problem = leitstand::fill(
            translate("leitstand::Topics", "The publisher is asked what {} is made of"), seen.type);
    else if (*text)
        watched.text = text->value();
    else
        watched.problem = text->error().text;
}

void TopicWatch::end() {
    std::unique_ptr<Subscription> ended;  // destroyed without the lock: it waits for its callback
    const std::scoped_lock lock(m_mutex);
    ended = std::move(m_subscription);
    m_watched.reset();
}

void TopicWatch::take(Watched& watched, const ReceivedSample& sample) {
    const SteadyTime now = steadyNow();
    const std::scoped_lock lock(watched.mutex);
    watched.newest = sample.event.cdr;
    ++watched.messages;
    const std::size_t size = sample.event.cdr ? sample.event.cdr->size() : 0;
    watched.received.emplace_back(now, size);
    while (watched.received.size() > MostReceived || now - watched.received.front().first > Window)
        watched.received.pop_front();
    if (watched.path.empty() || !watched.text || size == 0 || size > LargestPlotted) return;
    const auto read = inspect(*watched.text, *sample.event.cdr);
    const auto number = read ? numberAt(*read, watched.path) : std::nullopt;
    if (number) watched.numbers.emplace_back(now, *number);
    while (watched.numbers.size() > MostNumbers ||
           (!watched.numbers.empty() && secondsOf(now - watched.numbers.front().first) > PlotSpan))
        watched.numbers.pop_front();
}

std::optional<TopicView> TopicWatch::view() const {
    std::shared_ptr<Watched> watched;
    {
        const std::scoped_lock lock(m_mutex);
        watched = m_watched;
    }
    if (!watched) return std::nullopt;
    learn(*watched);
    const SteadyTime now = steadyNow();
    TopicView view;
    Payload newest;
    MessageTextPtr text;
    {
        const std::scoped_lock lock(watched->mutex);
        view.topic = watched->topic;
        view.type = watched->type;
        view.messages = watched->messages;
        view.problem = watched->problem;
        newest = watched->newest;
        text = watched->text;
        std::size_t bytes = 0, count = 0;
        for (const auto& [when, size] : watched->received) {
            if (now - when > Window) continue;
            ++count;
            bytes += size;
        }
        const double seconds = std::clamp(secondsOf(now - watched->since), 0.5, secondsOf(Window));
        view.rate = static_cast<double>(count) / seconds;
        view.megabits = 8e-6 * static_cast<double>(bytes) / seconds;
        if (!watched->received.empty()) view.age = secondsOf(now - watched->received.back().first);
    }
    if (!newest || !text) return view;
    const std::scoped_lock looking(watched->looking);
    if (watched->shown != newest) {
        watched->shown = newest;
        watched->inspected = inspect(*text, *newest);  // a text never changes
    }
    const Result<InspectedMessage>& read = *watched->inspected;
    if (read)
        view.newest = read.value();
    else
        view.problem = read.error().text;
    return view;
}

void TopicWatch::plot(const std::string& path) {
    const std::scoped_lock lock(m_mutex);
    if (!m_watched) return;
    const std::scoped_lock inner(m_watched->mutex);
    if (m_watched->path == path) return;
    m_watched->path = path;
    m_watched->numbers.clear();
}

std::vector<std::pair<double, double>> TopicWatch::plotted() const {
    const std::scoped_lock lock(m_mutex);
    std::vector<std::pair<double, double>> all;
    if (!m_watched) return all;
    const SteadyTime now = steadyNow();
    const std::scoped_lock inner(m_watched->mutex);
    for (const auto& [when, number] : m_watched->numbers) all.emplace_back(secondsOf(now - when), number);
    return all;
}

}  // namespace leitstand
