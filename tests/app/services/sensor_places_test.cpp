#include "app/services/places/sensor_places.h"

#include <chrono>
#include <utility>

#include <gtest/gtest.h>
#include <malloc.h>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

Event odometryAt(Time stamp) {
    OdometrySample odometry;
    odometry.header = {.stamp = stamp, .frame = "odom"};
    odometry.childFrame = "base_link";
    Event event;
    event.robot = "kurt3d";
    event.role = StreamRole::Odometry;
    event.received = stamp;
    event.sample = std::move(odometry);
    return event;
}

std::size_t allocated() {
    return mallinfo2().uordblks;
}

TEST(SensorPlaces, AnHourOfOdometryTakesNoMoreThanItsFirstFiveMinutes) {
    RobotDescription robot;
    robot.name = "kurt3d";
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    SensorPlaces places(robot);
    const Time start{1'000s};
    Time now = start;
    for (; now < start + 5min; now += 20ms) places.onEvent(odometryAt(now));
    const std::size_t after = allocated();
    for (; now < start + 1h; now += 20ms) places.onEvent(odometryAt(now));
    EXPECT_LT(allocated(), after + 100'000);
    EXPECT_TRUE(places.covers(now - 1s));
    EXPECT_TRUE(places.at("laser", "base_link", now - 1s).has_value());
}

}  // namespace
}  // namespace leitstand::test
