#include "widgets/models/map/decision_text.h"

#include <QCoreApplication>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct Texts {
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
            return (one ? Texts::tr("scan %1 accepted") : Texts::tr("%1 scans accepted")).arg(number);
        case Kind::SetAside:
            return (one ? Texts::tr("scan %1 set aside") : Texts::tr("%1 scans set aside")).arg(number);
        case Kind::Tried:
            return (one ? Texts::tr("scan %1 tried again") : Texts::tr("%1 scans tried again")).arg(number);
        case Kind::Crop:
            return Texts::tr("what belongs into the map");
        case Kind::Loop:
            return Texts::tr("a closed loop");
        case Kind::TidiedMap:
            return Texts::tr("the tidied map");
        case Kind::RefusedLoop:
            return Texts::tr("two places kept apart");
        case Kind::ReviewedFind:
            return Texts::tr("%1 as corrected in a review", "V1").arg(QString::fromStdString(thing.find));
        case Kind::ReviewNote:
            return Texts::tr("a note of a review");
        case Kind::Find:
            break;
    }
    return QString::fromStdString(thing.find);
}

}  // namespace leitstand
