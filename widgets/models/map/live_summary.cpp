#include "widgets/models/map/live_summary.h"

#include <algorithm>
#include <chrono>

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/map/doubt_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

constexpr double LongAgo = 100.0;  ///< [s]

struct Say {
    Q_DECLARE_TR_FUNCTIONS(leitstand::LiveSummary)
};

QString agoText(double seconds) {
    if (seconds < 10.0) return Say::tr("last scan %1 s ago").arg(numberText(std::max(seconds, 0.0), 1));
    if (seconds < LongAgo) return Say::tr("last scan %1 s ago").arg(numberText(seconds, 0));
    return Say::tr("last scan %1 min ago").arg(numberText(seconds / 60.0, 0));
}

}  // namespace

MapSummary liveSummaryOf(const LiveMap& map, const QString& followed, Time now, const QString& kind) {
    std::size_t scans = 0, points = 0;
    for (const LiveKeyScan& scan : map.scans) {
        if (scan.pose.trust == ScanTrust::SetAside) continue;
        ++scans;
        points += scan.scan->points.size();
    }
    MapSummary summary;
    QStringList title = {Say::tr("3D map")};
    if (!kind.isEmpty()) title += kind;
    if (scans > 0) {
        title += scans == 1 ? Say::tr("1 key scan") : Say::tr("%1 key scans").arg(countText(scans));
        // A map that follows is a small one beside a picture.
        if (followed.isEmpty()) title += Say::tr("%1 points").arg(shortCountText(points));
    }
    if (!followed.isEmpty()) title += Say::tr("follows %1").arg(followed);
    summary.title = title.join(QStringLiteral(" · "));
    if (map.scans.empty()) return summary;
    summary.hint =
        Say::tr("The newest key scan: its age, how much of it meets the map, and whether it is certain");
    const LiveKeyScan& newest = map.scans.back();
    // The verdict first: where there is little room, the age is what is cut.
    QStringList result = {trustText(newest.pose.trust)};
    if (newest.matched != 0) result += Say::tr("overlap %1").arg(percentText(newest.pose.overlap));
    result += agoText(std::chrono::duration<double>(now - newest.entered).count());
    summary.result = result.join(QStringLiteral(" · "));
    if (newest.pose.trust == ScanTrust::Uncertain) summary.tone = Tone::Attention;
    return summary;
}

}  // namespace leitstand
