#include "widgets/models/scan_texts.h"

#include <QCoreApplication>

#include "core/base/rotation/euler_angles.h"
#include "widgets/models/numbers.h"
#include "widgets/models/verdict.h"

namespace leitstand {
namespace {

struct ScanTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ScanListModel)
};

std::size_t countOf(const MapScan& scan, Label label) {
    return scan.labelCounts[static_cast<std::size_t>(label)];
}

QString labelShare(const MapScan& scan, Label label) {
    const std::size_t labelled =
        countOf(scan, Label::Floor) + countOf(scan, Label::Wall) + countOf(scan, Label::Ceiling);
    if (labelled == 0) return QStringLiteral("–");
    return percentText(static_cast<double>(countOf(scan, label)) / static_cast<double>(labelled));
}

QString ifRegistered(const MapScan& scan, const QString& text) {
    return scan.registered ? text : QStringLiteral("–");
}

QString verdictMark(Verdict verdict) {
    const bool loud = verdict == Verdict::Uncertain || verdict == Verdict::NotConverged;
    return loud ? QStringLiteral("▲ ") + verdictText(verdict) : verdictText(verdict);
}

}  // namespace

QString scanText(const MapScan& scan, ScanListModel::Column column) {
    switch (column) {
        case ScanListModel::Name:
            return QString::fromStdString(scan.scan->name);
        case ScanListModel::Position:
            return positionText(scan.poseInMap.translation());
        case ScanListModel::Heading:
            return degreesText(rollPitchYawOf(scan.poseInMap).z());
        case ScanListModel::Points:
            return countText(scan.scan->points.size());
        case ScanListModel::Floor:
            return labelShare(scan, Label::Floor);
        case ScanListModel::Wall:
            return labelShare(scan, Label::Wall);
        case ScanListModel::Ceiling:
            return labelShare(scan, Label::Ceiling);
        case ScanListModel::Iterations:
            return ifRegistered(scan, QString::number(scan.icp.iterations));
        case ScanListModel::Rms:
            return ifRegistered(scan, millimetresText(scan.icp.rms));
        case ScanListModel::Overlap:
            return ifRegistered(scan, percentText(scan.icp.overlap));
        case ScanListModel::Certainty:
            return verdictMark(verdictOf(scan));
        case ScanListModel::ColumnCount:
            break;
    }
    return {};
}

QString scanHint(const MapScan& scan, ScanListModel::Column column) {
    switch (column) {
        case ScanListModel::Points:
            return ScanTexts::tr("%1 of them used after range limits, filter and voxels")
                .arg(countText(scan.pointsUsed));
        case ScanListModel::Floor:
            return countText(countOf(scan, Label::Floor));
        case ScanListModel::Wall:
            return countText(countOf(scan, Label::Wall));
        case ScanListModel::Ceiling:
            return countText(countOf(scan, Label::Ceiling));
        case ScanListModel::Certainty:
            return verdictReason(scan);
        case ScanListModel::Name:
        case ScanListModel::Position:
        case ScanListModel::Heading:
        case ScanListModel::Iterations:
        case ScanListModel::Rms:
        case ScanListModel::Overlap:
        case ScanListModel::ColumnCount:
            break;
    }
    return {};
}

QString columnTitle(ScanListModel::Column column) {
    switch (column) {
        case ScanListModel::Name:
            return ScanTexts::tr("Scan");
        case ScanListModel::Position:
            return ScanTexts::tr("x y z m");
        case ScanListModel::Heading:
            return ScanTexts::tr("Heading");
        case ScanListModel::Points:
            return ScanTexts::tr("Points");
        case ScanListModel::Floor:
            return ScanTexts::tr("Floor");
        case ScanListModel::Wall:
            return ScanTexts::tr("Wall");
        case ScanListModel::Ceiling:
            return ScanTexts::tr("Ceiling");
        case ScanListModel::Iterations:
            return ScanTexts::tr("Steps");
        case ScanListModel::Rms:
            return ScanTexts::tr("RMS mm");
        case ScanListModel::Overlap:
            return ScanTexts::tr("Overlap");
        case ScanListModel::Certainty:
            return ScanTexts::tr("Certainty");
        case ScanListModel::ColumnCount:
            break;
    }
    return {};
}

QString columnHint(ScanListModel::Column column) {
    switch (column) {
        case ScanListModel::Name:
            return ScanTexts::tr("Name of the scan; the box shows or hides it");
        case ScanListModel::Position:
            return ScanTexts::tr("Position in the map: metres forward, left and up of the first scan");
        case ScanListModel::Heading:
            return ScanTexts::tr("Heading in the map, to the left of the first scan's");
        case ScanListModel::Points:
            return ScanTexts::tr("Points of the scan");
        case ScanListModel::Floor:
            return ScanTexts::tr("Share of the labelled points that is floor");
        case ScanListModel::Wall:
            return ScanTexts::tr("Share of the labelled points that is wall");
        case ScanListModel::Ceiling:
            return ScanTexts::tr("Share of the labelled points that is ceiling");
        case ScanListModel::Iterations:
            return ScanTexts::tr("Iterations of the ICP, over all stages");
        case ScanListModel::Rms:
            return ScanTexts::tr(
                "Root mean square distance of the point pairs at the end, in millimetres. Says "
                "little about the pose: overlap and certainty say more.");
        case ScanListModel::Overlap:
            return ScanTexts::tr("Share of the scan's points with a partner within 10 cm");
        case ScanListModel::Certainty:
            return ScanTexts::tr(
                "Whether the pose is held in every direction, from the smallest eigenvalue of "
                "the information matrix");
        case ScanListModel::ColumnCount:
            break;
    }
    return {};
}

std::vector<ScanDetail> scanDetails(const MapScan& scan) {
    const Eigen::Vector3d angles = rollPitchYawOf(scan.poseInMap);
    const auto share = [&scan](Label label, const QString& name) {
        return labelShare(scan, label) + QLatin1Char(' ') + name;
    };
    std::vector<ScanDetail> details = {
        {ScanTexts::tr("Position"), positionText(scan.poseInMap.translation()) + ScanTexts::tr("  m")},
        {ScanTexts::tr("Roll pitch heading"), degreesText(angles.x()) + QStringLiteral("  ") +
                                                  degreesText(angles.y()) + QStringLiteral("  ") +
                                                  degreesText(angles.z())},
        {ScanTexts::tr("Points"),
         ScanTexts::tr("%1, used %2").arg(countText(scan.scan->points.size()), countText(scan.pointsUsed))},
        {ScanTexts::tr("Labels"), share(Label::Floor, ScanTexts::tr("floor")) + QStringLiteral(" · ") +
                                      share(Label::Wall, ScanTexts::tr("wall")) + QStringLiteral(" · ") +
                                      share(Label::Ceiling, ScanTexts::tr("ceiling"))},
    };
    if (scan.registered) {
        const Pose correction = scan.guessInMap.inverse() * scan.poseInMap;
        details.push_back({ScanTexts::tr("Corrected by"),
                           ScanTexts::tr("%1 m, %2")
                               .arg(numberText(correction.translation().norm(), 3),
                                    degreesText(angleBetween(scan.guessInMap, scan.poseInMap)))});
        details.push_back({ScanTexts::tr("Registration"),
                           ScanTexts::tr("%1 steps in %2 s, RMS %3 mm")
                               .arg(QString::number(scan.icp.iterations), numberText(scan.seconds, 2),
                                    millimetresText(scan.icp.rms))});
    }
    details.push_back({ScanTexts::tr("Trust"), verdictReason(scan)});
    return details;
}

}  // namespace leitstand
