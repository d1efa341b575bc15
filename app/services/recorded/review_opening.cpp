#include "app/services/recorded/review_opening.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "app/services/recorded/review_cadence.h"
#include "app/services/recorded/review_index.h"
#include "app/services/recorded/review_log.h"
#include "core/event/stream_role.h"
#include "core/mission/state/scan_state.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

/// Roles that the strip shows.
constexpr std::array StripRoles = {StreamRole::Odometry, StreamRole::Imu, StreamRole::Mode,
                                   StreamRole::Battery, StreamRole::Gas};

/// Returns topics that panes on @p robot wait for. Of cameras these are the first and the last one, which are
/// shown first.
std::vector<std::string> awaitedOf(const RobotDescription& robot, bool slices) {
    std::vector<std::string> topics, cameras;
    for (const StreamRole role : {StreamRole::Picture, StreamRole::Thermal}) {
        for (const StreamDescription& stream : robot.streams)
            if (stream.role == role) cameras.push_back(stream.topic);
    }
    if (!cameras.empty()) topics = {cameras.front(), cameras.back()};
    for (const StreamDescription& stream : robot.streams) {
        const bool scanner = isScanner(stream.role);
        const bool shown = std::find(StripRoles.begin(), StripRoles.end(), stream.role) != StripRoles.end();
        if (scanner ? slices : shown) topics.push_back(stream.topic);
    }
    return topics;
}

/// Returns the moment at which half of the recorded time is over.
Time halfOf(const ReviewIndex& index) {
    auto left = recordedTime(index) / 2;
    for (const TimelineStretch& stretch : index.stretches) {
        if (stretch.to - stretch.from >= left) return stretch.from + left;
        left -= stretch.to - stretch.from;
    }
    return index.stretches.back().to;
}

}  // namespace

Time openingOf(ReviewLog& log, const ReviewIndex& index) {
    Time opening = log.first();
    if (log.robots().empty()) return index.finished->keyScans->empty() ? opening : log.last();
    const RobotDescription& robot = log.robots().front();
    const Time late = halfOf(index);
    const auto wait = [&](std::optional<Time> first) {
        if (first && *first <= late) opening = std::max(opening, *first);
    };
    const bool slices = hasSlices(index, robot.name);
    for (const std::string& topic : awaitedOf(robot, slices)) {
        // Searched for only if there are samples: a log may be large.
        if (usualRate(index, robot.name, topic) > 0.0) wait(log.firstOf(topic));
    }
    // Whole turns stand in for slices.
    if (const auto own = index.scanned.find(robot.name); own != index.scanned.end() && !slices)
        wait(own->second.front());
    std::optional<Time> mapped;
    for (const auto& [name, scans] : index.scanned) {
        if (!mapped || scans.front() < *mapped) mapped = scans.front();
    }
    wait(mapped);
    return opening;
}

}  // namespace leitstand
