#include "widgets/models/map/live_map_text.h"

#include <algorithm>
#include <chrono>
#include <optional>

#include <QCoreApplication>
#include <QStringList>

#include "core/event/scan_pose.h"
#include "widgets/models/map/doubt_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr double LongAgo = 100.0;  ///< [s]
constexpr QStringView Between = u" · ";

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::LiveSummary)
};

/// Returns when a robot's scan was last matched to the map.
std::optional<Time> lastMatched(const RobotsInMap& robots) {
    std::optional<Time> last;
    for (const RobotInMap& robot : robots) {
        if (robot.matched && (!last || *robot.matched > *last)) last = robot.matched;
    }
    return last;
}

QString agoText(double seconds) {
    if (seconds < 10.0) return Texts::tr("last scan %1 s ago").arg(numberText(std::max(seconds, 0.0), 1));
    if (seconds < LongAgo) return Texts::tr("last scan %1 s ago").arg(numberText(seconds, 0));
    return Texts::tr("last scan %1 min ago").arg(numberText(seconds / 60.0, 0));
}

}  // namespace

MapSummary liveSummaryOf(const LiveMapFacts& facts) {
    std::size_t scans = 0, points = 0;
    for (const LiveKeyScan& scan : facts.map.scans) {
        if (scan.pose.trust == ScanTrust::SetAside) continue;
        ++scans;
        points += scan.scan->points.size();
    }
    MapSummary summary;
    QStringList title = {Texts::tr("3D map")};
    if (!facts.kind.isEmpty()) title += facts.kind;
    if (!facts.maker.isEmpty()) title += Texts::tr("made by %1").arg(facts.maker);
    if (scans > 0) {
        title += scans == 1 ? Texts::tr("1 key scan") : Texts::tr("%1 key scans").arg(countText(scans));
    }
    QStringList brief = title;
    if (scans > 0) title += Texts::tr("%1 points").arg(shortCountText(points));
    if (!facts.followed.isEmpty()) {
        for (QStringList* const one : {&title, &brief}) *one += Texts::tr("follows %1").arg(facts.followed);
    }
    summary.title = title.join(Between);
    summary.briefTitle = brief.join(Between);
    if (facts.map.scans.empty()) return summary;
    summary.hint = Texts::tr(
        "The newest key scan: whether it is certain, and how much of it meets the map; and how long ago any "
        "scan was laid onto the map");
    const LiveKeyScan& newest = facts.map.scans.back();
    const std::optional<Time> matched = lastMatched(facts.robots);
    const double ago =
        std::chrono::duration<double>(facts.now - std::max(matched.value_or(newest.entered), newest.entered))
            .count();
    summary.stale = matched && ago >= MapStaleAfter;
    // The verdict comes first, so that the age is cut when there is too little room. A stale map has the age
    // first.
    QStringList parts = {trustText(newest.pose.trust), agoText(ago)};
    if (summary.stale) parts.swapItemsAt(0, 1);
    summary.briefResult = parts.join(Between);
    if (newest.matched != 0)
        parts.insert(summary.stale ? 2 : 1, Texts::tr("overlap %1").arg(percentText(newest.pose.overlap)));
    summary.result = parts.join(Between);
    if (newest.pose.trust == ScanTrust::Uncertain || summary.stale) summary.tone = Tone::Attention;
    return summary;
}

}  // namespace leitstand
