#include "app/services/recorded/review_cadence.h"

#include "app/services/recorded/review_index.h"
#include "core/base/time.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

double perSecond(double events, const ReviewIndex& index) {
    const double recorded = toSeconds(recordedTime(index));
    return recorded > 0.0 ? events / recorded : 0.0;
}

}  // namespace

std::chrono::nanoseconds recordedTime(const ReviewIndex& index) {
    std::chrono::nanoseconds recorded{};
    for (const TimelineStretch& stretch : index.stretches) recorded += stretch.to - stretch.from;
    return recorded;
}

double usualRate(const ReviewIndex& index, const std::string& robot, const std::string& topic) {
    const auto reported = index.finished->robots.find(robot);
    if (reported == index.finished->robots.end()) return 0.0;
    const auto stream = reported->second->streams.find(topic);
    return stream == reported->second->streams.end()
               ? 0.0
               : perSecond(static_cast<double>(stream->second.events), index);
}

double keyScanRate(const ReviewIndex& index, const std::string& robot) {
    const auto scans = index.scanned.find(robot);
    return scans == index.scanned.end() ? 0.0 : perSecond(static_cast<double>(scans->second.size()), index);
}

bool hasSlices(const ReviewIndex& index, const std::string& robot) {
    const auto reported = index.finished->robots.find(robot);
    if (reported == index.finished->robots.end()) return false;
    const auto scans = index.scanned.find(robot);
    const std::size_t keyScans = scans == index.scanned.end() ? 0 : scans->second.size();
    for (const auto& [topic, stream] : reported->second->streams) {
        if (!stream.role || !isScanner(*stream.role)) continue;
        if (stream.events > keyScans) return true;
    }
    return false;
}

}  // namespace leitstand
