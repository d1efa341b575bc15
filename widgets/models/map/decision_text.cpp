#include "widgets/models/map/decision_text.h"

#include <QCoreApplication>

namespace leitstand {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("DecisionText", text);
}

}  // namespace

QString decisionText(const MapDecision& decision) {
    using Kind = MapDecision::Kind;
    const auto count = static_cast<qulonglong>(decision.scans.size());
    const bool one = count == 1;
    const auto number = one ? static_cast<qulonglong>(decision.scans.front()) : count;
    switch (decision.kind) {
        case Kind::Taken:
            return (one ? tr("scan %1 accepted") : tr("%1 scans accepted")).arg(number);
        case Kind::SetAside:
            return (one ? tr("scan %1 set aside") : tr("%1 scans set aside")).arg(number);
        case Kind::Tried:
            return (one ? tr("scan %1 tried again") : tr("%1 scans tried again")).arg(number);
        case Kind::Crop:
            break;
    }
    return tr("what belongs into the map");
}

}  // namespace leitstand
