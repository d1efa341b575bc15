#include <bit>
#include <cmath>
#include <limits>

#include "core/event/all_samples.h"
#include "messages/livox_ros_driver2.h"
#include "messages/sensor_msgs.h"
#include "transport/convert/detail/cloud_column.h"
#include "transport/convert/detail/cloud_encoding.h"
#include "transport/convert/detail/cloud_times.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

using wire::sensor_msgs::PointCloud2;
using wire::sensor_msgs::PointField;
constexpr float NoEcho = std::numeric_limits<float>::quiet_NaN();
constexpr double LongestTurn = 60.0;  ///< of a plane laser [s]

std::size_t valueSize(unsigned datatype) {
    constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return datatype < std::size(sizes) ? sizes[datatype] : 0;
}

bool isFloat(unsigned datatype) {
    return datatype == PointField::FLOAT32_ || datatype == PointField::FLOAT64_;
}

/// Checks that the data holds as many points as the cloud's sizes claim; no count exceeds 64 bits.
void checkSizes(const PointCloud2& from, Checks& checks) {
    const std::uint64_t width = from.width, height = from.height, row = from.row_step;
    if (width == 0 || height == 0) return;
    checks.require(from.point_step > 0 && width * from.point_step <= row, "row_step",
                   "expected {} points of {} bytes in a row, found {} bytes", width, from.point_step, row);
    checks.require(row * (height - 1) + width * from.point_step <= from.data.size(), "data",
                   "expected {} rows of {} bytes, found {} bytes", height, row, from.data.size());
    checks.require(width <= std::numeric_limits<int>::max() && height <= std::numeric_limits<int>::max(),
                   "width", "expected less than 2^31, found {} x {}", width, height);
}

/// Returns the field of that name; empty when there is no such field or no point.
CloudColumn column(const PointCloud2& from, std::string_view name, Checks& checks) {
    for (const PointField& field : from.fields) {
        if (field.name != name) continue;
        const std::uint64_t end = std::uint64_t{field.offset} + valueSize(field.datatype);
        checks.require(valueSize(field.datatype) > 0, "fields",
                       "{}: expected a datatype from 1 to 8, found {}", name, field.datatype);
        checks.require(field.count <= 1, "fields", "{}: expected one value a point, found {}", name,
                       field.count);
        checks.require(end <= from.point_step, "fields", "{}: ends at byte {} of {} a point", name, end,
                       from.point_step);
        // A cloud without data may claim four thousand million rows: they are not iterated.
        const bool none = from.width == 0 || from.height == 0 || from.data.empty();
        if (!checks.ok() || none) return {};
        return {from.data.data() + field.offset,
                from.height,
                from.width,
                from.point_step,
                from.row_step,
                field.datatype,
                from.is_bigendian != (std::endian::native == std::endian::big)};
    }
    return {};
}

CloudColumn firstColumn(const PointCloud2& from, std::initializer_list<std::string_view> names,
                        Checks& checks) {
    for (const std::string_view name : names) {
        if (CloudColumn found = column(from, name, checks)) return found;
    }
    return {};
}

bool hasField(const PointCloud2& from, std::string_view name) {
    return std::any_of(from.fields.begin(), from.fields.end(),
                       [&](const PointField& field) { return field.name == name; });
}

/// Reads one coordinate of all points.
void readAxis(const PointCloud2& from, int axis, CloudSample& to, Checks& checks) {
    const char* name = axis == 0 ? "x" : axis == 1 ? "y" : "z";
    checks.require(hasField(from, name), "fields", "expected x, y and z, {} is missing", name);
    const CloudColumn found = column(from, name, checks);
    if (!found) return;
    checks.require(isFloat(found.datatype), "fields", "{}: expected float32 or float64, found datatype {}",
                   name, found.datatype);
    if (!checks.ok()) return;
    forEachValue(found, [&](std::size_t i, auto value) { to.points[i][axis] = static_cast<float>(value); });
}

void readTimes(const PointCloud2& from, CloudSample& to, Checks& checks) {
    const Time stamp = to.header.stamp;
    if (const CloudColumn t = column(from, "t", checks)) {
        to.times = relativeTimes(t, TimeUnit::Nanoseconds, stamp, checks);
    } else if (const CloudColumn time = column(from, "time", checks)) {
        const auto unit = isFloat(time.datatype) ? TimeUnit::Seconds : TimeUnit::Nanoseconds;
        to.times = relativeTimes(time, unit, stamp, checks);
    } else if (const CloudColumn timestamp = column(from, "timestamp", checks)) {
        const auto unit = isFloat(timestamp.datatype) ? TimeUnit::Seconds : TimeUnit::Nanoseconds;
        to.times = relativeTimes(timestamp, unit, stamp, checks);
    }
}

void readRings(const PointCloud2& from, CloudSample& to, Checks& checks) {
    const CloudColumn ring = firstColumn(from, {"ring", "line", "channel"}, checks);
    if (!ring) return;
    checks.require(!isFloat(ring.datatype), "fields", "ring: expected an integer, found datatype {}",
                   ring.datatype);
    if (!checks.ok()) return;
    to.rings.resize(to.points.size());
    // Rings below 0 are kept as they are: NOLINTNEXTLINE(bugprone-signed-char-misuse)
    forEachValue(ring, [&](std::size_t i, auto value) { to.rings[i] = static_cast<std::int32_t>(value); });
}

/// Marks points without an echo. Drivers of Ouster and Livox put them exactly where the scanner is.
void markNoEcho(std::vector<Eigen::Vector3f>& points) {
    for (Eigen::Vector3f& point : points) {
        if (!point.allFinite() || point.isZero(0.0F)) point.setConstant(NoEcho);
    }
}

/// A cloud of one row is a plain list of points, unless all points have the same ring.
bool isOrganised(const PointCloud2& from, const CloudSample& to) {
    if (from.height > 1) return true;
    return !to.rings.empty() && from.width > 1 &&
           std::all_of(to.rings.begin(), to.rings.end(),
                       [&](std::int32_t ring) { return ring == to.rings.front(); });
}

}  // namespace

CloudSample fromWire(const PointCloud2& from, const Source&, Checks& checks) {
    CloudSample to;
    to.header = checks.header(from.header);
    checkSizes(from, checks);
    if (!checks.ok()) return to;
    if (from.width > 0 && from.height > 0) {
        for (const char* name : {"x", "y", "z"}) {  // before memory is taken for the points
            checks.require(static_cast<bool>(column(from, name, checks)), "fields",
                           "expected x, y and z, {} is missing", name);
        }
        if (!checks.ok()) return to;
        to.points.resize(std::size_t{from.width} * from.height);
    }
    for (int axis = 0; axis < 3; ++axis) readAxis(from, axis, to, checks);
    markNoEcho(to.points);
    if (const CloudColumn intensity = firstColumn(from, {"intensity", "reflectivity"}, checks)) {
        to.intensities.resize(to.points.size());
        forEachValue(intensity,
                     [&](std::size_t i, auto value) { to.intensities[i] = static_cast<float>(value); });
    }
    readTimes(from, to, checks);
    readRings(from, to, checks);
    if (checks.ok() && !to.points.empty() && isOrganised(from, to)) {
        to.rows = static_cast<int>(from.height);
        to.columns = static_cast<int>(from.width);
    }
    return to;
}

CloudSample fromWire(const wire::livox_ros_driver2::CustomMsg& from, const Source&, Checks& checks) {
    constexpr std::uint64_t Alike = 1'000'000'000;  // stamp and timebase of one clock [ns]
    CloudSample to;
    to.header = checks.header(from.header);
    const auto stamp = static_cast<std::uint64_t>(to.header.stamp.time_since_epoch().count());
    // Both mean the first point. If somebody stamped it again by another clock, the stamp counts.
    const std::uint64_t after = from.timebase - stamp;  // modulo 2^64
    const bool alike = after < Alike || after > ~std::uint64_t{0} - Alike;
    const std::int64_t before = alike ? static_cast<std::int64_t>(after) : 0;
    const std::size_t count = from.points.size();
    to.points.reserve(count);
    to.intensities.reserve(count);
    to.times.reserve(count);
    to.rings.reserve(count);
    for (const auto& point : from.points) {
        to.points.emplace_back(point.x, point.y, point.z);
        to.intensities.push_back(point.reflectivity);
        to.times.push_back(before + point.offset_time);
        to.rings.push_back(point.line);
    }
    markNoEcho(to.points);
    return to;
}

RangesSample fromWire(const wire::sensor_msgs::LaserScan& from, const Source&, Checks& checks) {
    checks.require(from.ranges.size() < 2 || from.angle_increment != 0.0F, "angle_increment",
                   "expected another angle for each of {} rays", from.ranges.size());
    checks.require(from.intensities.empty() || from.intensities.size() == from.ranges.size(), "intensities",
                   "expected {} or none, found {}", from.ranges.size(), from.intensities.size());
    checks.require(from.range_min <= from.range_max, "range_max", "expected at least {}, found {}",
                   from.range_min, from.range_max);
    const double turn = std::abs(double{from.time_increment}) * static_cast<double>(from.ranges.size());
    checks.require(turn <= LongestTurn, "time_increment", "expected {} s for all {} rays at most, found {} s",
                   LongestTurn, from.ranges.size(), turn);
    return {checks.header(from.header),
            checks.finite("angle_min", from.angle_min),
            checks.finite("angle_increment", from.angle_increment),
            checks.finite("time_increment", from.time_increment),
            checks.finite("scan_time", from.scan_time),
            checks.finite("range_min", from.range_min),
            from.range_max,
            from.ranges,
            from.intensities};
}

std::vector<Conversion> cloudConversions() {
    return {
        conversion<wire::sensor_msgs::PointCloud2, CloudSample>(),
        conversion<wire::livox_ros_driver2::CustomMsg, CloudSample>(),
        conversion<wire::sensor_msgs::LaserScan, RangesSample>(),
    };
}

}  // namespace leitstand::detail
