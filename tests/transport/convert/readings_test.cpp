// Numbers of messages of any type.
#include <bit>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/unknown.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "messages/diagnostic_msgs.h"
#include "messages/sensor_msgs.h"
#include "messages/std_msgs.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/convert/decode.h"
#include "transport/convert/readings/field_numbers.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <class Message>
std::vector<std::byte> bytesOf(const Message& message, std::endian order = std::endian::little) {
    CdrWriter out(order);
    encode(out, message);
    return std::move(out).finish();
}

wire::sensor_msgs::BatteryState battery() {
    wire::sensor_msgs::BatteryState message;
    message.header = {{1'700'000'000, 5}, "bms"};
    message.voltage = 12.5F;
    message.power_supply_status = 2;
    message.present = true;
    message.cell_voltage = {4.0F, 4.25F, 3.5F};
    message.location = "rear";
    return message;
}

std::vector<double> numbers(const std::vector<std::byte>& bytes, const char* type,
                            const std::vector<std::string>& paths) {
    const auto found = numbersAt(*knownText(type), paths, bytes);
    EXPECT_TRUE(found) << found.error().text;
    return found ? found->values : std::vector<double>();
}

TEST(FieldNumbers, AreFoundByTheirPaths) {
    for (const std::endian order : {std::endian::little, std::endian::big}) {
        EXPECT_THAT(
            numbers(bytesOf(battery(), order), "sensor_msgs/msg/BatteryState",
                    {"cell_voltage[1]", "voltage", "present", "power_supply_status", "header.stamp.sec"}),
            ElementsAre(4.25, 12.5, 1.0, 2.0, 1'700'000'000.0));
    }
    const auto absent = numbers(bytesOf(battery()), "sensor_msgs/msg/BatteryState", {"cell_voltage[3]"});
    ASSERT_EQ(absent.size(), 1U);
    EXPECT_TRUE(std::isnan(absent[0])) << "the array is too short";
}

TEST(FieldNumbers, LieInStructuresInArrays) {
    wire::diagnostic_msgs::DiagnosticArray message;
    message.status = {{0, "a", "fine", "k", {{"x", "1"}}}, {2, "b", "hot", "k", {}}};
    EXPECT_THAT(numbers(bytesOf(message), "diagnostic_msgs/msg/DiagnosticArray", {"status[1].level"}),
                ElementsAre(2.0));
    wire::sensor_msgs::CameraInfo info;
    info.k[4] = 525.0;
    EXPECT_THAT(numbers(bytesOf(info), "sensor_msgs/msg/CameraInfo", {"k[4]", "roi.width"}),
                ElementsAre(525.0, 0.0));
}

TEST(FieldNumbers, OfAVectorIsItsLength) {
    wire::sensor_msgs::MagneticField field;
    field.magnetic_field = {3e-5, 0.0, 4e-5};
    EXPECT_THAT(
        numbers(bytesOf(field), "sensor_msgs/msg/MagneticField", {"magnetic_field", "magnetic_field.z"}),
        ElementsAre(testing::DoubleNear(5e-5, 1e-12), 4e-5));
}

TEST(FieldNumbers, PathsToNoNumberAreRefusedWithWhatIsThere) {
    const MessageText& text = *knownText("sensor_msgs/msg/BatteryState");
    for (const char* path : {"volt", "header", "header.frame_id", "voltage.x", "cell_voltage", "voltage[0]",
                             "location", "", "header.stamp"})
        EXPECT_FALSE(checkPaths(text, std::vector<std::string>{path})) << path;
    const auto wrong = checkPaths(text, std::vector<std::string>{"volt"});
    EXPECT_THAT(wrong.error().text, HasSubstr("(header, voltage, temperature,"));
    EXPECT_THAT(wrong.error().text, HasSubstr("\"volt\""));
    EXPECT_FALSE(checkPaths(*knownText("sensor_msgs/msg/CameraInfo"), std::vector<std::string>{"k[9]"}))
        << "it has nine numbers";
}

TEST(FieldNumbers, MessagesOfOtherLayoutsAreRefused) {
    const auto bytes = bytesOf(battery());
    const MessageText& text = *knownText("sensor_msgs/msg/BatteryState");
    const std::vector<std::string> paths = {"voltage", "cell_voltage[2]"};
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(numbersAt(text, paths, std::span(bytes).first(size))) << size;
    std::mt19937 random(3);
    for (int i = 0; i < 20'000; ++i) {
        auto hostile = bytes;
        for (int flips = 0; flips < 3; ++flips)
            hostile[random() % hostile.size()] = std::byte(random() % 256);
        (void)numbersAt(text, paths, hostile);
    }
    auto longer = bytes;
    longer.resize(bytes.size() + 64);
    EXPECT_FALSE(numbersAt(text, paths, longer));
}

StreamDescription stream(const char* type, std::vector<ReadingDescription> readings) {
    StreamDescription made;
    made.role = StreamRole::Reading;
    made.topic = "/kurt3d/x";
    made.type = type;
    made.readings = std::move(readings);
    return made;
}

TEST(Readings, AreInTheUnitsThatTheFileNames) {
    wire::sensor_msgs::FluidPressure message;
    message.header = {{1'700'000'000, 5}, "air"};
    message.fluid_pressure = 101'325.0;
    RobotDescription robot;
    robot.name = "kurt3d";
    const RawEvent event{1, Time(), "/kurt3d/x", "sensor_msgs/msg/FluidPressure",
                         std::make_shared<const std::vector<std::byte>>(bytesOf(message))};
    const auto decoded =
        decodeEvent(event, robot,
                    stream("sensor_msgs/msg/FluidPressure", usualReadings("sensor_msgs/msg/FluidPressure")));
    ASSERT_TRUE(decoded) << decoded.error().text;
    const auto* const reading = decoded->sample.as<ReadingSample>();
    ASSERT_NE(reading, nullptr);
    EXPECT_THAT(reading->values, ElementsAre(testing::DoubleNear(1013.25, 1e-9)));
    EXPECT_EQ(reading->header.frame, "kurt3d/air");
    EXPECT_EQ(reading->header.stamp, Time(std::chrono::seconds(1'700'000'000) + std::chrono::nanoseconds(5)));
}

TEST(Readings, ThatAreNoNumbersAreUnknownAndInfiniteOnesStay) {
    wire::std_msgs::Float32 message;
    const auto read = [&](float value) {
        message.data = value;
        const RawEvent event{1, Time(), "/kurt3d/x", "std_msgs/msg/Float32",
                             std::make_shared<const std::vector<std::byte>>(bytesOf(message))};
        const auto decoded = decode(event, stream("std_msgs/msg/Float32", {{"data", "x", ""}}));
        EXPECT_TRUE(decoded) << decoded.error().text;
        return decoded ? decoded->get<ReadingSample>().values.at(0) : 0.0;
    };
    EXPECT_TRUE(std::isnan(read(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_EQ(read(-std::numeric_limits<float>::infinity()), -std::numeric_limits<double>::infinity())
        << "REP 117: too near";
}

TEST(Readings, OfATypeThatNobodyKnowsAreRefused) {
    const RawEvent event{1, Time(), "/kurt3d/x", "my_robot/msg/Cells",
                         std::make_shared<const std::vector<std::byte>>(64)};
    const auto decoded = decode(event, stream("my_robot/msg/Cells", {{"data", "x", ""}}));
    ASSERT_FALSE(decoded);
    EXPECT_THAT(decoded.error().text,
                HasSubstr("/kurt3d/x: my_robot/msg/Cells: the fields of messages of type"));
}

// Jazzy appended a variance.
TEST(Readings, OfANewerRangeAreTaken) {
    wire::sensor_msgs::Range message;
    message.range = 1.5F;
    auto bytes = bytesOf(message);
    bytes.resize(bytes.size() + sizeof(float));
    EXPECT_THAT(numbers(bytes, "sensor_msgs/msg/Range", {"range"}), ElementsAre(1.5));
}

}  // namespace
}  // namespace leitstand::test
