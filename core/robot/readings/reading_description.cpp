#include "core/robot/readings/reading_description.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/robot/robot_description.h"

namespace leitstand {
namespace {

constexpr double Inside = 0.02;  ///< share of a limit by which a number must be inside, so that a level ends

/// A number that is usual in messages of a type.
struct Usual {
    std::string_view type;
    const char* field;
    const char* title;
    const char* unit;
    double scale = 1.0;
    std::optional<int> decimals = {};
};

// Units of the messages: REP 103, and the comments in the .msg files of sensor_msgs.
constexpr Usual Table[] = {
    {"sensor_msgs/msg/Temperature", "temperature", translatable("leitstand::Readings", "temperature"), "°C"},
    {"sensor_msgs/msg/RelativeHumidity", "relative_humidity", translatable("leitstand::Readings", "humidity"),
     "%", 100.0},
    {"sensor_msgs/msg/FluidPressure", "fluid_pressure", translatable("leitstand::Readings", "pressure"),
     "hPa", 0.01},
    {"sensor_msgs/msg/MagneticField", "magnetic_field", translatable("leitstand::Readings", "magnetic field"),
     "µT", 1e6},
    {"sensor_msgs/msg/Range", "range", translatable("leitstand::Readings", "distance"), "m"},
    {"sensor_msgs/msg/Illuminance", "illuminance", translatable("leitstand::Readings", "light"), "lx"},
    {"sensor_msgs/msg/NavSatFix", "latitude", translatable("leitstand::Readings", "latitude"), "°", 1.0, 6},
    {"sensor_msgs/msg/NavSatFix", "longitude", translatable("leitstand::Readings", "longitude"), "°", 1.0, 6},
    {"sensor_msgs/msg/NavSatFix", "altitude", translatable("leitstand::Readings", "altitude"), "m"},
};

/// Returns by how much a number must be inside of @p limit, so that a standing level ends. @p opposite: the
/// limit on the other side; most of the range between the two stays normal.
double insideOf(double limit, const std::optional<double>& opposite) {
    constexpr double MostOfRange = 0.1;
    const double margin = Inside * std::abs(limit);
    if (!opposite) return margin;
    const double range = std::abs(*opposite - limit);
    return limit == 0.0 ? Inside * range : std::min(margin, MostOfRange * range);
}

/// Whether @p value is outside of @p low to @p high.
bool isOutside(const std::optional<double>& low, const std::optional<double>& high, double value,
               bool standing) {
    const double above = high ? *high - (standing ? insideOf(*high, low) : 0.0) : 0.0;
    const double below = low ? *low + (standing ? insideOf(*low, high) : 0.0) : 0.0;
    return (high && value > above) || (low && value < below);
}

}  // namespace

ReadingLevel levelOf(const ReadingLimits& limits, double value, ReadingLevel standing) {
    if (std::isnan(value)) return ReadingLevel::Normal;
    if (isOutside(limits.lowAct, limits.highAct, value, standing == ReadingLevel::Act))
        return ReadingLevel::Act;
    if (isOutside(limits.low, limits.high, value, standing != ReadingLevel::Normal))
        return ReadingLevel::Attention;
    return ReadingLevel::Normal;
}

std::vector<ReadingDescription> usualReadings(std::string_view type) {
    std::vector<ReadingDescription> found;
    for (const Usual& one : Table) {
        if (one.type == type) found.push_back({one.field, one.title, one.unit, one.scale, 0.0, one.decimals});
    }
    return found;
}

void distinguishReadings(RobotDescription& robot) {
    constexpr std::size_t Longest = 120;  // of a title in a file [B]
    std::map<std::string, int> times, seen;
    for (const StreamDescription& stream : robot.streams) {
        for (const ReadingDescription& reading : stream.readings) ++times[reading.title];
    }
    for (StreamDescription& stream : robot.streams) {
        for (ReadingDescription& reading : stream.readings) {
            const std::string title = reading.title;
            if (times[title] < 2) continue;
            reading.title = fmt::format("{} {}", title, stream.topic);
            if (reading.title.size() > Longest)
                reading.title = fmt::format("{} {}", title.substr(0, Longest / 2), ++seen[title]);
        }
    }
}

}  // namespace leitstand
