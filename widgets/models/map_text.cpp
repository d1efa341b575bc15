#include "widgets/models/map_text.h"

#include <algorithm>

#include <QCoreApplication>

#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/verdict.h"

namespace leitstand {
namespace {

struct SummaryTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::MapSummary)
};

QString titleOf(const Map& map) {
    if (map.scans.empty()) return SummaryTexts::tr("3D map");
    std::size_t points = 0;
    for (const MapScan& scan : map.scans) points += scan.scan->points.size();
    if (map.scans.size() == 1)
        return SummaryTexts::tr("3D map · 1 scan · %1 points").arg(shortCountText(points));
    return SummaryTexts::tr("3D map · %1 scans · %2 points")
        .arg(countText(map.scans.size()), shortCountText(points));
}

QString verdictOver(const Map& map, Tone& tone) {
    for (const Verdict wanted : {Verdict::NotConverged, Verdict::Uncertain}) {
        const auto bad = [&](const MapScan& scan) { return verdictOf(scan) == wanted; };
        const auto first = std::find_if(map.scans.begin(), map.scans.end(), bad);
        if (first == map.scans.end()) continue;
        tone = Tone::Attention;
        const auto count = std::count_if(map.scans.begin(), map.scans.end(), bad);
        return count == 1 ? SummaryTexts::tr("%1 %2").arg(othersText(first->scan->name), verdictText(wanted))
                          : SummaryTexts::tr("%1 scans %2")
                                .arg(countText(static_cast<std::size_t>(count)), verdictText(wanted));
    }
    return verdictText(Verdict::Certain);
}

}  // namespace

MapSummary summaryOf(const Map& map) {
    MapSummary summary{titleOf(map),
                       {},
                       Tone::Normal,
                       SummaryTexts::tr("Time of all registrations, and the lowest overlap of all scans")};
    double seconds = 0.0, overlap = 1.0;
    bool any = false;
    for (const MapScan& scan : map.scans) {
        seconds += scan.seconds;
        if (!scan.registered) continue;
        any = true;
        overlap = std::min(overlap, scan.icp.overlap);
    }
    if (!any) return summary;
    const QString verdict = verdictOver(map, summary.tone);
    summary.result = SummaryTexts::tr("registered in %1 s · overlap %2 · %3")
                         .arg(numberText(seconds, 1), percentText(overlap), verdict);
    return summary;
}

}  // namespace leitstand
