#include "widgets/models/live/texts/goal_text.h"

#include <cmath>

#include <QCoreApplication>

#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct GoalTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::GoalText)
};

}  // namespace

QString goalNote(const NavigationView& navigation) {
    switch (navigation.stage) {
        case GoalStage::Asked:
            return GoalTexts::tr("sent to its goal");
        case GoalStage::Cancelling:
            return GoalTexts::tr("gives up its goal");
        case GoalStage::UnderWay:
            break;
        case GoalStage::None:
        case GoalStage::Arrived:
        case GoalStage::Cancelled:
        case GoalStage::Failed:
        case GoalStage::Refused:
        case GoalStage::Unanswered:
            return {};
    }
    if (!std::isfinite(navigation.metresLeft)) return GoalTexts::tr("drives to its goal");
    QString note = GoalTexts::tr("%1 m to go").arg(numberText(navigation.metresLeft, 1));
    if (std::isfinite(navigation.secondsLeft) && navigation.secondsLeft > 0.0)
        note += QStringLiteral(" · ") + secondsText(navigation.secondsLeft);
    if (navigation.recoveries > 0)
        note += QStringLiteral(" · ") +
                GoalTexts::tr("stuck: %1", "so often on its way").arg(navigation.recoveries);
    return note;
}

QString goalEnd(GoalStage stage) {
    switch (stage) {
        case GoalStage::Arrived:
            return GoalTexts::tr("%1 has arrived");
        case GoalStage::Cancelled:
            return GoalTexts::tr("%1: its goal was cancelled");
        case GoalStage::Failed:
            return GoalTexts::tr("%1 gave up on the way to its goal");
        case GoalStage::Refused:
            return GoalTexts::tr("%1 does not accept the goal");
        case GoalStage::Unanswered:
            return GoalTexts::tr("%1 does not answer: the goal may not have reached it");
        case GoalStage::None:
        case GoalStage::Asked:
        case GoalStage::UnderWay:
        case GoalStage::Cancelling:
            return {};
    }
    return {};
}

}  // namespace leitstand
