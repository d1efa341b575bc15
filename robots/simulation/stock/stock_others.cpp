#include "robots/simulation/stock/stock_others.h"

#include <chrono>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/io/settings/folders.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/encode.h"
#include "transport/convert/readings/field_numbers.h"

namespace leitstand::simulation {
namespace {

/// Returns a message of @p type without content. Of a type that the station does not know: the encapsulation
/// of XCDR1, little endian, and zeros, which are empty strings and sequences in whatever message has them.
Payload nothingOf(std::string_view type) {
    const Sample known[] = {JointSample{},         OdometrySample{},   ImuSample{}, CameraInfoSample{},
                            OccupancyGridSample{}, GridUpdateSample{}, PathSample{}};
    for (const Sample& sample : known) {
        if (auto payload = encode(sample, type)) return std::move(payload).value();
    }
    if (const MessageText* const text = knownText(type)) {
        if (auto payload = messageWith(*text, {}, {})) return std::move(payload).value();
    }
    constexpr std::size_t Bytes = 1'024;
    std::vector<std::byte> bytes(Bytes);
    bytes[1] = std::byte{1};
    return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

/// Returns the message with the robot's model, resources/stock/NAME.urdf. The error names the file.
Result<Payload> modelOf(const StockProfile& profile) {
    const std::filesystem::path file = shippedFolder("stock") / (std::string(profile.name) + ".urdf");
    std::ifstream in(file);
    std::string urdf(std::istreambuf_iterator<char>(in), {});
    if (!in || urdf.empty()) return Error{file.string() + ": expected the model of the stock robot"};
    return encode(Sample(RobotModelSample{std::move(urdf)}), "std_msgs/msg/String");
}

}  // namespace

Result<StockOthers> StockOthers::create(Node& node, const StockProfile& profile,
                                        const std::string& nameSpace) {
    StockOthers others;
    for (const StockTopic& topic : profile.others) {
        auto made = node.publisher(
            {.topic = topicIn(nameSpace, topic.topic), .type = std::string(topic.type), .qos = topic.qos});
        if (!made) return made.error();
        Lane lane{std::move(made).value(), nothingOf(topic.type), {}, {}};
        if (topic.topic == streamFacts(StreamRole::Model).topic) {
            auto model = modelOf(profile);
            if (!model) return model.error();
            lane.message = std::move(model).value();
        }
        if (topic.rate > 0.0)
            lane.every = std::chrono::duration_cast<std::chrono::nanoseconds>(
                std::chrono::duration<double>(1.0 / topic.rate));
        others.m_lanes.push_back(std::move(lane));
    }
    return others;
}

void StockOthers::publish(Time now) {
    for (Lane& lane : m_lanes) {
        if (now < lane.next) continue;
        (void)lane.publisher->write(lane.message);  // nobody misses it
        lane.next = lane.every.count() == 0 ? Time::max() : now + lane.every;
    }
}

}  // namespace leitstand::simulation
