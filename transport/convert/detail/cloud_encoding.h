#pragma once

#include "core/event/cloud_sample.h"
#include "messages/livox_ros_driver2.h"
#include "messages/sensor_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {

// As conversion() requires them.
void toWire(const CloudSample& from, wire::sensor_msgs::PointCloud2& to, Buffer& buffer, Checks& checks);
void toWire(const CloudSample& from, wire::livox_ros_driver2::CustomMsg& to, Buffer&, Checks& checks);
void toWire(const RangesSample& from, wire::sensor_msgs::LaserScan& to, Buffer&, Checks& checks);

}  // namespace leitstand::detail
