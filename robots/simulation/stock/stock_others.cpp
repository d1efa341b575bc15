#include "robots/simulation/stock/stock_others.h"

#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/event/raw_event.h"

namespace leitstand::simulation {
namespace {

/// A message without content: the encapsulation of XCDR1, little endian, and zeros, which are empty strings,
/// empty sequences and zero stamps in whatever message has them.
Payload nothing() {
    constexpr std::size_t Bytes = 256;
    std::vector<std::byte> bytes(Bytes);
    bytes[1] = std::byte{1};
    return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

}  // namespace

Result<StockOthers> StockOthers::create(Node& node, const StockProfile& profile,
                                        const std::string& nameSpace) {
    StockOthers others;
    for (const StockTopic& topic : profile.others) {
        auto made = node.publisher(
            {.topic = topicIn(nameSpace, topic.topic), .type = std::string(topic.type), .qos = topic.qos});
        if (!made) return made.error();
        Lane lane{std::move(made).value(), {}, {}};
        if (topic.rate > 0.0)
            lane.every = std::chrono::duration_cast<std::chrono::nanoseconds>(
                std::chrono::duration<double>(1.0 / topic.rate));
        others.m_lanes.push_back(std::move(lane));
    }
    return others;
}

void StockOthers::publish(Time now) {
    static const Payload Empty = nothing();
    for (Lane& lane : m_lanes) {
        if (now < lane.next) continue;
        (void)lane.publisher->write(Empty);  // nobody misses it
        lane.next = lane.every.count() == 0 ? Time::max() : now + lane.every;
    }
}

}  // namespace leitstand::simulation
