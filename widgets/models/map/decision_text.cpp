#include "widgets/models/map/decision_text.h"

#include <QCoreApplication>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct Say {
    Q_DECLARE_TR_FUNCTIONS(leitstand::DecisionText)
};

}  // namespace

QString decisionText(const MapDecision& decision) {
    return undoneText(undoneThing(decision));
}

QString undoneText(const UndoneThing& thing) {
    using Kind = UndoneThing::Kind;
    const bool one = thing.scans == 1;
    const QString number = one ? QString::number(thing.scan) : countText(thing.scans);
    switch (thing.kind) {
        case Kind::Taken:
            return (one ? Say::tr("scan %1 accepted") : Say::tr("%1 scans accepted")).arg(number);
        case Kind::SetAside:
            return (one ? Say::tr("scan %1 set aside") : Say::tr("%1 scans set aside")).arg(number);
        case Kind::Tried:
            return (one ? Say::tr("scan %1 tried again") : Say::tr("%1 scans tried again")).arg(number);
        case Kind::Crop:
            return Say::tr("what belongs into the map");
        case Kind::Loop:
            return Say::tr("a closed loop");
        case Kind::TidiedMap:
            return Say::tr("the tidied map");
        case Kind::RefusedLoop:
            return Say::tr("a place told from another");
        case Kind::ReviewedFind:
            return Say::tr("%1 as corrected in a review", "V1").arg(QString::fromStdString(thing.find));
        case Kind::ReviewNote:
            return Say::tr("a note of a review");
        case Kind::Find:
            break;
    }
    return QString::fromStdString(thing.find);
}

}  // namespace leitstand
