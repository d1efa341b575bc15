#include "app/window/review/merge_progress.h"

#include <exception>
#include <string>
#include <system_error>

#include <QCoreApplication>

#include "app/services/progress_part.h"
#include "app/services/recorded/merged_map.h"
#include "app/services/review/map_tidying.h"
#include "app/window/shell/work_in_front.h"

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ReviewWindow)
};

QString nameOf(const std::filesystem::path& mission) {
    const bool slash = !mission.has_filename();
    return QString::fromStdString((slash ? mission.parent_path() : mission).filename().string());
}

MergingOutcome done(const MergeOrder& order, const Progress& progress) {
    constexpr double Merging = 0.6;  // share of the work
    try {
        const auto merged = mergeMaps(order, part(progress, 0.0, Merging));
        if (!merged) return {{}, QString::fromStdString(merged.error().text)};
        const QString first = nameOf(order.first), second = nameOf(order.second);
        if (!merged->together)
            return {order.into, Words::tr("How the maps of %1 and %2 lie to each other is not sure: they lie "
                                          "side by side. A station that goes on with this mission joins them "
                                          "by hand")
                                    .arg(first, second)};
        TidySettings tidying;
        tidying.version = order.version;
        const auto tidied = tidyMap(order.into, tidying, part(progress, Merging, 1.0));
        QString text = Words::tr("The maps of %1 and %2 are one: of %3 places that were looked for, %4 agree")
                           .arg(first, second)
                           .arg(merged->sought)
                           .arg(merged->agreeing);
        if (merged->aside > 0)
            text += Words::tr("; key scans in parts that were mapped apart and are not in it: %1")
                        .arg(merged->aside);
        if (!tidied) text += QStringLiteral("; ") + QString::fromStdString(tidied.error().text);
        return {order.into, text};
    } catch (const std::exception& problem) {  // out of memory
        return {{}, problem.what()};
    }
}

}  // namespace

std::filesystem::path mergedName(const std::filesystem::path& mission, const std::filesystem::path& other) {
    const std::filesystem::path folder = mission.has_filename() ? mission : mission.parent_path();
    const std::string name = (nameOf(mission) + QStringLiteral("+") + nameOf(other)).toStdString();
    std::filesystem::path merged = folder.parent_path() / name;
    std::error_code none;
    for (int number = 2; std::filesystem::exists(merged, none); ++number)
        merged = folder.parent_path() / (name + "-" + std::to_string(number));
    return merged;
}

MergingOutcome mergeInFront(const std::filesystem::path& mission, const std::filesystem::path& other) {
    MergeOrder order;
    order.first = mission;
    order.second = other;
    order.into = mergedName(mission, other);
    order.version = QCoreApplication::applicationVersion().toStdString();
    MergingOutcome came;
    workInFront({.name = QStringLiteral("merging"),
                 .label = Words::tr("The maps of %1 and %2 are being merged. The new mission opens then.")
                              .arg(nameOf(mission), nameOf(other))},
                [&](const Progress& progress) { came = done(order, progress); });
    return came;
}

}  // namespace leitstand
