#include "widgets/models/live/texts/sight_text.h"

#include <cmath>

#include <QCoreApplication>

#include "widgets/models/live/texts/freshness.h"

namespace leitstand {
namespace {

struct SightTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::SightLine)
};

QString whyOf(const SightCap& sight) {
    switch (sight.reason) {
        case SightReason::Fresh:
            return {};
        case SightReason::ScanAlone:
        case SightReason::OldPicture:
            return std::isfinite(sight.age)
                       ? SightTexts::tr("the picture is %1 old").arg(secondsText(sight.age))
                       : SightTexts::tr("there is no picture");
        case SightReason::FrozenPicture:
            return SightTexts::tr("it is the same picture for %1").arg(secondsText(sight.age));
        case SightReason::NoPicture:
            return SightTexts::tr("there is no picture");
        case SightReason::OldScan:
            return std::isfinite(sight.age)
                       ? SightTexts::tr("the scan of the way is %1 old").arg(secondsText(sight.age))
                       : SightTexts::tr("there is no scan of the way");
        case SightReason::NoEyes:
            return SightTexts::tr("no camera, no scanner: you must see it");
    }
    return {};
}

}  // namespace

SightLine sightLineOf(const DriveView& drive) {
    const SightCap& sight = drive.sight;
    const QString why = whyOf(sight);
    if (sight.overridden) {
        return {sight.isBlind() ? SightTexts::tr("override: driving without eyes · %1").arg(why)
                                : SightTexts::tr("override held: nothing caps the speed"),
                Tone::Attention};
    }
    if (sight.factor >= 1.0) {
        if (sight.reason == SightReason::ScanAlone)
            return {SightTexts::tr("%1: drive by the virtual scan").arg(why), Tone::Attention};
        return {why, Tone::Muted};  // none, or the driver must see the robot
    }
    if (sight.factor > 0.0) return {SightTexts::tr("creep speed: %1").arg(why), Tone::Attention};
    return {SightTexts::tr("held: %1 · hold G to drive without eyes").arg(why), Tone::Attention};
}

QString sightNote(const DriveView& drive) {
    if (!drive.focus) return {};
    const SightCap& sight = drive.sight;
    if (sight.overridden)
        return sight.isBlind() ? SightTexts::tr("override: driving without eyes")
                               : SightTexts::tr("override");
    if (sight.factor <= 0.0) return SightTexts::tr("held");
    return sight.factor < 1.0 ? SightTexts::tr("creep speed") : SightTexts::tr("full speed");
}

}  // namespace leitstand
