
#include "core/event/stream_role.h"
#include "fuzz/input_file.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/convert/message_catalog.h"

namespace {

using namespace leitstand;

RobotDescription robotOf(const StreamDescription& stream) {
    RobotDescription robot;
    robot.letter = "K";
    robot.name = "kurt3d";
    robot.streams = {stream};
    return robot;
}

}  // namespace

/// Samples of robots and stations. The first byte chooses the type, the second the role of the stream (modulo
/// their numbers), the third how frames and thermal pictures are told; the rest is CDR as on the wire.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return 0;
    const auto types = messageTypes();
    RawEvent event;
    event.sequence = 1;
    event.topic = "/kurt3d/topic";
    event.type = types[data[0] % types.size()].rosName;
    const auto* bytes = reinterpret_cast<const std::byte*>(data);
    event.cdr = std::make_shared<const std::vector<std::byte>>(bytes + 3, bytes + size);
    StreamDescription stream;
    stream.role = allStreamRoles()[data[1] % allStreamRoles().size()];
    stream.topic = event.topic;
    stream.type = event.type;
    stream.readings = usualReadings(stream.type);
    if (stream.readings.empty()) {
        for (const char* field :
             {"data", "data[1]", "header.stamp.sec", "pose.pose.position", "status[0].level"})
            stream.readings.push_back({field, field, ""});
    }
    stream.thermal.measured = (data[2] & 4) == 0;
    RobotDescription robot = robotOf(stream);
    robot.tfPrefix = static_cast<TfPrefix>(data[2] % 3);

    const auto sample = decode(event, stream);
    fuzz::require(sample.ok() || !sample.error().text.empty(), "an error that tells something");
    const auto named = decodeEvent(event, robot, stream);
    fuzz::require(named.ok() || !named.error().text.empty(), "an error that tells something");
    const auto own = decodeStationEvent(event);
    fuzz::require(own.ok() || !own.error().text.empty(), "an error that tells something");
    if (sample) {
        // What was understood can be said again, or the reason why not is told.
        const auto again = encode(*sample, event.type);
        fuzz::require(again.ok() || !again.error().text.empty(), "an error that tells something");
    }
    return 0;
}
