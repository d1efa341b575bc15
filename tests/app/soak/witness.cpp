#include "tests/app/soak/witness.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>
#include <thread>
#include <unordered_map>
#include <utility>

#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/robot/streams/stream_table.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t Some = 5;  ///< samples of a steady stream
constexpr auto Patience = 60s;
constexpr auto Lasting = 2s;  ///< states that stay come at once

std::string_view textOf(const Payload& cdr) {
    return {reinterpret_cast<const char*>(cdr->data()), cdr->size()};
}

/// Robots may share a topic: diagnostics tell whose they are.
bool isOf(const StreamDescription& stream, const Payload& cdr) {
    return stream.hardwareId.empty() || textOf(cdr).find(stream.hardwareId) != std::string_view::npos;
}

std::size_t printOf(const Payload& cdr) {
    return std::hash<std::string_view>()(textOf(cdr));
}

/// Samples of one stream as they stand in a log.
class LoggedStream {
public:
    void add(std::size_t bytes) {
        const auto [found, isNew] = m_places.emplace(bytes, m_count++);
        if (!isNew) found->second = Twice;
    }
    /// The how manieth sample it is that has @p bytes; empty where there is none, or more than one.
    [[nodiscard]] std::optional<std::uint64_t> placeOf(std::size_t bytes) const {
        const auto found = m_places.find(bytes);
        if (found == m_places.end() || found->second == Twice) return std::nullopt;
        return found->second;
    }

private:
    static constexpr std::uint64_t Twice = ~std::uint64_t{0};
    std::uint64_t m_count = 0;
    std::unordered_map<std::size_t, std::uint64_t> m_places;
};

}  // namespace

Witness::Witness(const TestDomain& domain, const std::vector<RobotDescription>& robots) : m_domain(domain) {
    for (const RobotDescription& robot : robots) {
        for (const StreamDescription& stream : robot.streams) {
            if (!isCommand(stream.role) && stream.record) m_streams.push_back({robot.name, stream});
        }
    }
}

bool Witness::listen() {
    NodeSettings settings;
    settings.name = "witness";
    settings.interfaces = {"lo"};
    const auto node = nodeIn(m_domain, settings);
    std::vector<std::unique_ptr<Subscription>> subscriptions;
    for (Stream& stream : m_streams) {
        stream.before = stream.received.size();
        const StreamDescription& one = stream.description;
        const Lane lane = one.role == StreamRole::Points ? Lane::Large : Lane::Small;
        subscriptions.push_back(must(
            node->subscribe({one.topic, one.type, one.qos, lane},
                            [this, &stream](const ReceivedSample& sample) { receive(stream, sample); })));
    }
    const bool all = waitUntil([this] { return heardSome(); }, Patience);
    std::this_thread::sleep_for(Lasting);
    return all;
}

void Witness::receive(Stream& stream, const ReceivedSample& sample) {
    if (!isOf(stream.description, sample.event.cdr)) return;
    const std::scoped_lock lock(m_mutex);
    stream.received.push_back({printOf(sample.event.cdr), sample.writerSequence});
}

bool Witness::heardSome() const {
    const std::scoped_lock lock(m_mutex);
    return std::all_of(m_streams.begin(), m_streams.end(), [](const Stream& stream) {
        return !streamFacts(stream.description.role).steady || stream.received.size() >= stream.before + Some;
    });
}

std::vector<Kept> Witness::compare(const std::filesystem::path& mission) const {
    const std::scoped_lock lock(m_mutex);
    std::vector<LoggedStream> logged(m_streams.size());
    std::multimap<std::string, std::size_t> byTopic;
    BagQuery query;
    for (std::size_t i = 0; i < m_streams.size(); ++i) {
        const std::string& topic = m_streams[i].description.topic;
        if (!byTopic.contains(topic)) query.topics.push_back(topic);
        byTopic.emplace(topic, i);
    }
    const auto bag = must(BagReader::open(mission));
    BagCursor cursor = bag->read(query);
    while (const auto event = cursor.next()) {
        const auto [first, end] = byTopic.equal_range(event->topic);
        for (auto one = first; one != end; ++one) {
            if (isOf(m_streams[one->second].description, event->cdr))
                logged[one->second].add(printOf(event->cdr));
        }
    }
    std::vector<Kept> all;
    for (std::size_t i = 0; i < m_streams.size(); ++i) {
        const Stream& stream = m_streams[i];
        const auto isLogged = [&](const Print& print) { return logged[i].placeOf(print.bytes).has_value(); };
        const auto first = std::find_if(stream.received.begin(), stream.received.end(), isLogged);
        const auto last = std::find_if(stream.received.rbegin(), stream.received.rend(), isLogged);
        Kept kept{stream.description.topic, stream.robot,
                  stream.description.qos.reliability == Qos::Reliability::Reliable};
        if (first != stream.received.end()) {
            kept.sent = last->sequence - first->sequence + 1;
            kept.logged = *logged[i].placeOf(last->bytes) - *logged[i].placeOf(first->bytes) + 1;
        } else if (!stream.received.empty()) {
            kept.sent = stream.received.back().sequence - stream.received.front().sequence + 1;
        }
        all.push_back(std::move(kept));
    }
    return all;
}

}  // namespace leitstand::test
