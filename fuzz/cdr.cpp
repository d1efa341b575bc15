#include "fuzz/input_file.h"
#include "messages/diagnostic_msgs.h"
#include "messages/leitstand_msgs.h"
#include "messages/nav_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/tf2_msgs.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/dds/ros_nodes.h"

namespace {

using namespace leitstand;

template <class Message>
std::vector<std::byte> written(const Message& message) {
    CdrWriter out(std::endian::little);
    encode(out, message);
    return std::move(out).finish();
}

/// What can be read can be written, and reads the same.
template <class Message>
void check(std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    Message message;
    decode(in, message);
    if (!in.finish()) return;
    const auto once = written(message);
    CdrReader again(once);
    Message same;
    decode(again, same);
    fuzz::require(again.finish().ok(), "a message that can be read again");
    fuzz::require(written(same) == once, "the same message again");
}

using Check = void (*)(std::span<const std::byte>);

template <class... Messages>
constexpr std::array<Check, sizeof...(Messages)> checks() {
    return {&check<Messages>...};
}

using namespace wire;
constexpr auto Checks =
    checks<sensor_msgs::PointCloud2, sensor_msgs::Image, sensor_msgs::CompressedImage, sensor_msgs::LaserScan,
           sensor_msgs::JointState, sensor_msgs::CameraInfo, sensor_msgs::BatteryState, sensor_msgs::Imu,
           nav_msgs::Odometry, tf2_msgs::TFMessage, diagnostic_msgs::DiagnosticArray,
           leitstand_msgs::Sightings, leitstand_msgs::Victim, leitstand_msgs::KeyScan,
           leitstand_msgs::ScanPoses, leitstand_msgs::Checkpoint, leitstand_msgs::Grant,
           leitstand_msgs::StopCommand, leitstand_msgs::Alarm, leitstand_msgs::MapCrop,
           leitstand_msgs::ScanLinks, leitstand_msgs::ScanBodies>();

}  // namespace

/// The structs that stand for messages; the first byte chooses which, the rest is CDR.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static_cast<void>(leitstand::rosProcess({reinterpret_cast<const std::byte*>(data), size}));
    Checks[data[0] % Checks.size()]({reinterpret_cast<const std::byte*>(data + 1), size - 1});
    return 0;
}
