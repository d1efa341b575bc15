#include "widgets/models/verdict.h"

#include <QCoreApplication>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct VerdictTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::Verdict)
};

QString stopReason(IcpStop stop) {
    switch (stop) {
        case IcpStop::Converged:
            return VerdictTexts::tr("The iteration came to rest.");
        case IcpStop::LimitCycle:
            return VerdictTexts::tr("The iteration ended swinging between two poses.");
        case IcpStop::IterationLimit:
            return VerdictTexts::tr("The limit of iterations was reached before the pose came to rest.");
        case IcpStop::Degenerate:
            return VerdictTexts::tr(
                "Too few pairs of points: the scan stands where it was expected. A larger "
                "maximum distance may help.");
        case IcpStop::Cancelled:
            return VerdictTexts::tr("The registration was cancelled.");
    }
    return {};
}

}  // namespace

Verdict verdictOf(const MapScan& scan) {
    if (!scan.registered) return Verdict::Reference;
    if (!scan.icp.converged) return Verdict::NotConverged;
    return scan.icp.certain() ? Verdict::Certain : Verdict::Uncertain;
}

QString verdictText(Verdict verdict) {
    switch (verdict) {
        case Verdict::Reference:
            return VerdictTexts::tr("reference");
        case Verdict::Certain:
            return VerdictTexts::tr("certain");
        case Verdict::Uncertain:
            return VerdictTexts::tr("uncertain");
        case Verdict::NotConverged:
            return VerdictTexts::tr("not converged");
    }
    return {};
}

QString verdictReason(const MapScan& scan) {
    switch (verdictOf(scan)) {
        case Verdict::Reference:
            return VerdictTexts::tr(
                "The first scan defines the map's frame; the others are registered to it.");
        case Verdict::NotConverged:
            return stopReason(scan.icp.stop);
        case Verdict::Uncertain:
            return VerdictTexts::tr(
                       "Some direction is hardly held, as along a bare corridor: certainty %1, "
                       "below %2.")
                .arg(numberText(scan.icp.certainty, 3), numberText(IcpResult::UncertainBelow, 3));
        case Verdict::Certain:
            return VerdictTexts::tr("Every direction is held: certainty %1 (uncertain below %2).")
                .arg(numberText(scan.icp.certainty, 3), numberText(IcpResult::UncertainBelow, 3));
    }
    return {};
}

}  // namespace leitstand
