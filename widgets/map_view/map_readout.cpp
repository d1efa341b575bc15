#include "widgets/map_view/map_readout.h"

#include <QCoreApplication>

#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct ReadoutTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::MapReadout)
};

QString labelName(Label label) {
    switch (label) {
        case Label::Floor:
            return ReadoutTexts::tr("floor");
        case Label::Wall:
            return ReadoutTexts::tr("wall");
        case Label::Ceiling:
            return ReadoutTexts::tr("ceiling");
        case Label::Unlabelled:
            break;
    }
    return ReadoutTexts::tr("unlabelled");
}

}  // namespace

QString pickText(const std::optional<PickedPoint>& point, const Map& map) {
    if (!point || point->scan < 0 || point->scan >= static_cast<int>(map.scans.size())) return {};
    const Eigen::Vector3d& at = point->pointInMap;
    const Scan& scan = *map.scans[static_cast<std::size_t>(point->scan)].scan;
    return ReadoutTexts::tr("x %1  y %2  z %3 m · %4 · %5")
        .arg(numberText(at.x(), 2), numberText(at.y(), 2), numberText(at.z(), 2), labelName(point->label),
             othersText(scan.name.empty() ? scan.robot : scan.name));
}

QString measurementText(const Measurement& measurement) {
    const Eigen::Vector3d step = measurement.to - measurement.from;
    return ReadoutTexts::tr("%1 m · dx %2 m  dy %3 m  dz %4 m")
        .arg(numberText(step.norm(), 2), numberText(step.x(), 2), numberText(step.y(), 2),
             numberText(step.z(), 2));
}

}  // namespace leitstand
