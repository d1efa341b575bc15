#include "widgets/models/live/stop_line.h"

#include <QCoreApplication>

#include "widgets/models/live/freshness.h"

namespace leitstand {
namespace {

struct StopTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::StopLine)
};

StopStage stageOf(const StopStatus& stop) {
    if (!stop.sent && !stop.stopped) return StopStage::None;
    if (stop.releasing) return StopStage::Releasing;
    // Robots that know no stops answer none: their motion alone tells.
    if (stop.supported && stop.sent && !stop.acknowledged) return StopStage::Sent;
    if (stop.standingKnown && stop.standing) return StopStage::Standing;
    return stop.supported ? StopStage::Acknowledged : StopStage::Sent;
}

QString textOf(StopStage stage, const StopStatus& stop) {
    switch (stage) {
        case StopStage::None:
            return {};
        case StopStage::Sent: {
            if (!stop.supported) return StopTexts::tr("held by zeros");
            const double seconds = std::chrono::duration<double>(stop.unanswered).count();
            return seconds < 0.5 ? StopTexts::tr("sent")
                                 : StopTexts::tr("sent · no answer for %1").arg(secondsText(seconds));
        }
        case StopStage::Acknowledged:
            return stop.standingKnown ? StopTexts::tr("acknowledged · moves")
                                      : StopTexts::tr("acknowledged · motion unknown");
        case StopStage::Standing:
            return StopTexts::tr("standing");
        case StopStage::Releasing:
            return StopTexts::tr("releasing");
    }
    return {};
}

QString detailsOf(const StopStatus& stop, bool mine) {
    if (!stop.refused.empty())
        return StopTexts::tr("The release did nothing: %1").arg(QString::fromStdString(stop.refused));
    if (!stop.supported)
        return StopTexts::tr("The robot knows no stops: it is held by drive commands of zero.");
    if (stop.stopped && !stop.sent) {
        return stop.stoppedBy.empty() ? StopTexts::tr("Stopped by the robot's own button.")
                                      : StopTexts::tr("Stopped by another station.");
    }
    if (!mine) return StopTexts::tr("Only who has the grant to drive can release it.");
    return {};
}

}  // namespace

StopLine stopLineOf(const RobotFace& face, const RobotView& robot) {
    const StopStatus& stop = robot.stop;
    StopLine line;
    line.face = face;
    line.stage = stageOf(stop);
    if (line.stage == StopStage::None) return line;
    line.text = textOf(line.stage, stop);
    line.details = detailsOf(stop, robot.grant.mine);
    const bool calm = line.stage == StopStage::Standing || line.stage == StopStage::Releasing;
    line.tone = calm ? Tone::Normal : Tone::Attention;
    if (line.stage == StopStage::Sent && stop.unanswered > std::chrono::seconds(1)) line.tone = Tone::Act;
    const bool taken = !stop.sent || stop.acknowledged || !stop.supported;
    line.releasable = robot.grant.mine && taken && !stop.releasing;
    return line;
}

}  // namespace leitstand
