#include "widgets/models/review/compared_text.h"

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/numbers.h"
#include "widgets/models/review/comparison_rows.h"

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ComparedSummary)
};

}  // namespace

QString comparedMapText(ComparedMap which) {
    switch (which) {
        case ComparedMap::Recorded:
            return Texts::tr("recorded");
        case ComparedMap::Again:
            return Texts::tr("registered again");
        case ComparedMap::Both:
            break;
    }
    return Texts::tr("recorded (grey) and registered again");
}

MapSummary comparedSummaryOf(const MapComparison& comparison, ComparedMap which) {
    const QStringList title = {Texts::tr("3D map"), comparedMapText(which),
                               Texts::tr("%1 key scans").arg(countText(comparison.scans.size()))};
    MapSummary summary;
    summary.title = title.join(QStringLiteral(" · "));
    summary.result = movedText(comparison);
    summary.hint = Texts::tr("How far key scans are from where they were recorded");
    return summary;
}

}  // namespace leitstand
