#include <limits>

#include "transport/convert/detail/cloud_encoding.h"

namespace leitstand::detail {
namespace {

using wire::sensor_msgs::PointField;
constexpr std::int64_t MostT = std::numeric_limits<std::uint32_t>::max();
constexpr double NanosecondsOfSecond = 1e9;

/// Writes values of type T of all points, one point's step apart.
template <class T, class Get>
void put(Buffer& buffer, std::size_t offset, std::size_t step, std::size_t count, Get get) {
    for (std::size_t i = 0; i < count; ++i) {
        const T value = static_cast<T>(get(i));
        std::memcpy(buffer.data() + i * step + offset, &value, sizeof(T));
    }
}

bool within(const auto& values, std::int64_t least, std::int64_t most) {
    return std::all_of(values.begin(), values.end(),
                       [&](auto value) { return value >= least && value <= most; });
}

void checkLists(const CloudSample& from, Checks& checks) {
    const std::size_t count = from.points.size();
    const std::size_t grid = static_cast<std::size_t>(from.rows) * static_cast<std::size_t>(from.columns);
    checks.require(from.rows >= 0 && from.columns >= 0 && (!from.organised() || grid == count),
                   "rows, columns", "{} x {} does not fit {} points", from.rows, from.columns, count);
    for (const std::size_t size : {from.intensities.size(), from.times.size(), from.rings.size()}) {
        checks.require(size == 0 || size == count, "points", "lists of {} and {} values", count, size);
    }
}

}  // namespace

/// Writes the layout of docs/design.md, "The wire". Times that do not fit `t` become `timestamp`, in seconds
/// after the stamp.
void toWire(const CloudSample& from, wire::sensor_msgs::PointCloud2& to, Buffer& buffer, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    checkLists(from, checks);
    if (!checks.ok()) return;
    const std::size_t count = from.points.size();
    const bool shortTimes = within(from.times, 0, MostT);
    const bool shortRings = within(from.rings, 0, std::numeric_limits<std::uint16_t>::max());
    std::uint32_t step = 0;
    const auto field = [&](const char* name, std::uint8_t datatype, std::uint32_t size) {
        to.fields.push_back({name, step, datatype, 1});
        return std::exchange(step, step + size);
    };
    for (const char* axis : {"x", "y", "z"}) field(axis, PointField::FLOAT32_, 4);
    const std::size_t intensity = from.intensities.empty() ? 0 : field("intensity", PointField::FLOAT32_, 4);
    const std::size_t time = from.times.empty() ? 0
                             : shortTimes       ? field("t", PointField::UINT32_, 4)
                                                : field("timestamp", PointField::FLOAT64_, 8);
    const std::size_t ring = from.rings.empty() ? 0
                             : shortRings       ? field("ring", PointField::UINT16_, 2)
                                                : field("ring", PointField::INT32_, 4);
    buffer.resize(count * step);
    for (int axis = 0; axis < 3; ++axis) {
        put<float>(buffer, static_cast<std::size_t>(axis) * 4, step, count,
                   [&](std::size_t i) { return from.points[i][axis]; });
    }
    put<float>(buffer, intensity, step, from.intensities.size(),
               [&](std::size_t i) { return from.intensities[i]; });
    if (shortTimes) {
        put<std::uint32_t>(buffer, time, step, from.times.size(),
                           [&](std::size_t i) { return from.times[i]; });
    } else {
        put<double>(buffer, time, step, count,
                    [&](std::size_t i) { return static_cast<double>(from.times[i]) / NanosecondsOfSecond; });
    }
    const auto ringOf = [&](std::size_t i) { return from.rings[i]; };
    if (shortRings) {
        put<std::uint16_t>(buffer, ring, step, from.rings.size(), ringOf);
    } else {
        put<std::int32_t>(buffer, ring, step, count, ringOf);
    }
    to.height = from.organised() ? static_cast<std::uint32_t>(from.rows) : 1;
    to.width =
        from.organised() ? static_cast<std::uint32_t>(from.columns) : static_cast<std::uint32_t>(count);
    to.point_step = step;
    to.row_step = to.width * step;
    to.data = buffer;
    to.is_dense = std::all_of(from.points.begin(), from.points.end(),
                              [](const Eigen::Vector3f& point) { return point.allFinite(); });
}

/// Intensities are cut to 0 to 255. Points without an echo become zeros, as the driver sends them.
void toWire(const CloudSample& from, wire::livox_ros_driver2::CustomMsg& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    checkLists(from, checks);
    checks.require(within(from.times, 0, MostT), "offset_time", "expected 0 to {} ns after the stamp", MostT);
    checks.require(within(from.rings, 0, 255), "line", "expected 0 to 255");
    checks.require(from.points.size() <= MostT, "points", "expected less than 2^32, found {}",
                   from.points.size());
    if (!checks.ok()) return;
    to.timebase = static_cast<std::uint64_t>(from.header.stamp.time_since_epoch().count());
    to.point_num = static_cast<std::uint32_t>(from.points.size());
    to.points.resize(from.points.size());
    for (std::size_t i = 0; i < from.points.size(); ++i) {
        auto& point = to.points[i];
        const Eigen::Vector3f place = from.points[i].allFinite() ? from.points[i] : Eigen::Vector3f::Zero();
        point.x = place.x();
        point.y = place.y();
        point.z = place.z();
        if (!from.times.empty()) point.offset_time = static_cast<std::uint32_t>(from.times[i]);
        if (!from.intensities.empty())
            point.reflectivity = static_cast<std::uint8_t>(std::clamp(from.intensities[i], 0.0F, 255.0F));
        if (!from.rings.empty()) point.line = static_cast<std::uint8_t>(from.rings[i]);
    }
}

void toWire(const RangesSample& from, wire::sensor_msgs::LaserScan& to, Buffer&, Checks& checks) {
    checks.require(from.intensities.empty() || from.intensities.size() == from.ranges.size(), "intensities",
                   "expected {} or none, found {}", from.ranges.size(), from.intensities.size());
    const double steps = from.ranges.empty() ? 0.0 : static_cast<double>(from.ranges.size() - 1);
    to.header = checks.wireHeader(from.header);
    to.angle_min = static_cast<float>(checks.finite("angle_min", from.angleMin));
    to.angle_max = static_cast<float>(from.angleMin + steps * from.angleStep);
    to.angle_increment = static_cast<float>(checks.finite("angle_increment", from.angleStep));
    to.time_increment = static_cast<float>(checks.finite("time_increment", from.timeStep));
    to.scan_time = static_cast<float>(checks.finite("scan_time", from.turnTime));
    to.range_min = static_cast<float>(checks.finite("range_min", from.rangeMin));
    to.range_max = static_cast<float>(from.rangeMax);
    to.ranges = from.ranges;
    to.intensities = from.intensities;
}

}  // namespace leitstand::detail
