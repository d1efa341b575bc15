#include "app/services/review/reviewed_streams.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>

#include "app/services/recorded/review_cadence.h"
#include "core/base/time.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds LongestWindow(5);
constexpr double Steady = 0.2;      // [Hz]: more rarely, a stream is sent when something changes
constexpr double StaleAfter = 4.0;  // in usual intervals between two samples of the mission
constexpr double NeverStale = 1.0;  // [s]: samples of any stream are this old now and then

const StreamState* find(const MissionState& state, const std::string& robot, const std::string& topic) {
    const auto reported = state.robots.find(robot);
    if (reported == state.robots.end()) return nullptr;
    const auto stream = reported->second->streams.find(topic);
    return stream == reported->second->streams.end() ? nullptr : &stream->second;
}

}  // namespace

RateWindow RateWindow::before(Time now, const ReviewIndex& index) {
    RateWindow window{now - LongestWindow, now};
    for (const TimelineStretch& stretch : index.stretches) {
        if (stretch.from <= now) window.from = std::max(now - LongestWindow, stretch.from);
    }
    return window;
}

std::vector<StreamStatus> reviewedStreams(const RobotDescription& robot, const MissionState& earlier,
                                          const MissionState& state, const RateWindow& window,
                                          const ReviewIndex& index) {
    constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<StreamStatus> streams;
    for (const StreamDescription& described : robot.streams) {
        if (isCommand(described.role)) continue;
        StreamStatus status;
        status.role = described.role;
        status.sensor = described.sensor;
        status.topic = described.topic;
        status.lossRatio = status.megabitsPerSecond = Unknown;
        if (const StreamState* const reported = find(state, robot.name, described.topic)) {
            const StreamState* const before = find(earlier, robot.name, described.topic);
            status.samples = reported->events;
            status.age = std::max(0.0, secondsBetween(reported->received, window.to));
            const double length = secondsBetween(window.from, window.to);
            const auto came =
                reported->events - std::min(reported->events, before == nullptr ? 0 : before->events);
            status.rate = length > 0.0 ? static_cast<double>(came) / length : 0.0;
            const double usual = usualRate(index, robot.name, described.topic);
            status.steady = usual >= Steady;
            status.stale = status.steady && status.age > std::max(NeverStale, StaleAfter / usual);
        }
        streams.push_back(std::move(status));
    }
    return streams;
}

}  // namespace leitstand
