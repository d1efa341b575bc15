#include "widgets/models/map/decision_text.h"

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Say {
    Q_DECLARE_TR_FUNCTIONS(leitstand::DecisionText)
};

}  // namespace

QString decisionText(const MapDecision& decision) {
    using Kind = MapDecision::Kind;
    const auto count = static_cast<qulonglong>(decision.scans.size());
    const bool one = count == 1;
    const auto number = one ? static_cast<qulonglong>(decision.scans.front()) : count;
    switch (decision.kind) {
        case Kind::Taken:
            return (one ? Say::tr("scan %1 accepted") : Say::tr("%1 scans accepted")).arg(number);
        case Kind::SetAside:
            return (one ? Say::tr("scan %1 set aside") : Say::tr("%1 scans set aside")).arg(number);
        case Kind::Tried:
            return (one ? Say::tr("scan %1 tried again") : Say::tr("%1 scans tried again")).arg(number);
        case Kind::Crop:
            break;
    }
    return Say::tr("what belongs into the map");
}

}  // namespace leitstand
