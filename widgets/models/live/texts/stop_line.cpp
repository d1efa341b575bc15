#include "widgets/models/live/texts/stop_line.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/base/time.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr double Unanswered = 0.5;  ///< from then on the time without an answer is shown [s]

struct StopTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::StopLine)
};

StopStage stageOf(const StopStatus& stop) {
    if (stop.releasing) return StopStage::Releasing;
    if (!stop.sent && !stop.stopped) return StopStage::None;
    // Robots that know no stops answer none: only their motion shows the stop.
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
            const double seconds = toSeconds(stop.unanswered);
            return seconds < Unanswered ? StopTexts::tr("sent")
                                        : StopTexts::tr("sent · no answer for %1").arg(secondsText(seconds));
        }
        case StopStage::Acknowledged:
            return stop.standingKnown ? StopTexts::tr("confirmed · moves")
                                      : StopTexts::tr("confirmed · motion unknown");
        case StopStage::Standing:
            return StopTexts::tr("standing");
        case StopStage::Releasing:
            return StopTexts::tr("releasing");
    }
    return {};
}

/// "4.2 s", "1:40": shorter than secondsText().
QString briefSeconds(double seconds) {
    constexpr double Few = 9.95, Many = 99.5, Hour = 3600.0;
    if (seconds < Many) return StopTexts::tr("%1 s").arg(numberText(seconds, seconds < Few ? 1 : 0));
    if (seconds >= Hour) return StopTexts::tr("> 1 h");
    const int whole = static_cast<int>(seconds);
    return QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

/// "? 4.2 s": the time without an answer.
QString briefSilence(double seconds) {
    return StopTexts::tr("? %1", "a stop, not answered for 4.2 s").arg(briefSeconds(seconds));
}

QString briefOf(StopStage stage, const StopStatus& stop) {
    switch (stage) {
        case StopStage::None:
            return {};
        case StopStage::Sent: {
            if (!stop.supported) return StopTexts::tr("held", "by zeros");
            const double seconds = toSeconds(stop.unanswered);
            return seconds < Unanswered ? StopTexts::tr("sent", "where there is little room")
                                        : briefSilence(seconds);
        }
        case StopStage::Acknowledged:
            return stop.standingKnown ? StopTexts::tr("moves") : StopTexts::tr("moves?");
        case StopStage::Standing:
            return StopTexts::tr("stands");
        case StopStage::Releasing:
            return StopTexts::tr("release", "is on its way");
    }
    return {};
}

/// What a service of the robot has done of the stop; empty: it confirmed it, or has no part in it now.
QString serviceText(const StopServiceStatus& service) {
    const QString title = othersText(service.title);
    if (service.refused && service.message.empty()) return StopTexts::tr("%1 refuses.").arg(title);
    if (service.refused)
        return StopTexts::tr("%1 refuses: %2.", "a service, its own words")
            .arg(title, othersText(service.message));
    if (!service.offered && !service.message.empty())
        return StopTexts::tr("%1 cannot be called: %2.", "a service, why")
            .arg(title, othersText(service.message));
    switch (service.stage) {
        case StopServiceStatus::Stage::Asked:
            return service.offered ? StopTexts::tr("%1 has not confirmed yet.").arg(title)
                                   : StopTexts::tr("Nobody offers %1.").arg(title);
        case StopServiceStatus::Stage::Releasing:
            return StopTexts::tr("%1 has not released yet.").arg(title);
        case StopServiceStatus::Stage::Idle:
        case StopServiceStatus::Stage::Stopped:
            return {};
    }
    return {};
}

QString servicesText(const StopStatus& stop) {
    QStringList all;
    for (const StopServiceStatus& service : stop.services) {
        if (const QString text = serviceText(service); !text.isEmpty()) all += text;
    }
    if (!all.isEmpty()) return all.join(QLatin1Char(' '));
    if (!stop.sent || stop.services.empty()) return {};
    if (stop.services.size() == 1)
        return StopTexts::tr("%1 confirmed it.").arg(othersText(stop.services.front().title));
    return StopTexts::tr("%1 services confirmed it.").arg(stop.services.size());
}

/// What holds a robot that knows no stops.
QString holdOf(const StopStatus& stop) {
    if (!stop.locks) return StopTexts::tr("The robot knows no stops: it is held by drive commands of zero.");
    return stop.lockHeard
               ? StopTexts::tr(
                     "The robot knows no stops: it is held by drive commands of zero and by its lock.")
               : StopTexts::tr(
                     "The robot knows no stops: it is held by drive commands of zero. Nobody listens "
                     "to its lock.");
}

QString detailsOf(const StopStatus& stop, bool mine) {
    if (!stop.refused.empty())
        return StopTexts::tr("The release did nothing: %1").arg(othersText(stop.refused));
    QString services = servicesText(stop);
    if (!stop.supported)
        return services.isEmpty() ? holdOf(stop) : services + QLatin1Char(' ') + holdOf(stop);
    if (!services.isEmpty()) return services;
    if (stop.stopped && !stop.sent) {
        return stop.stoppedBy.empty() ? StopTexts::tr("Stopped by the robot's own button.")
                                      : StopTexts::tr("Stopped by another station.");
    }
    if (!mine) return StopTexts::tr("Only the station with drive control can release it.");
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
    line.brief = briefOf(line.stage, stop);
    line.details = detailsOf(stop, robot.grant.mine);
    const bool calm = line.stage == StopStage::Standing || line.stage == StopStage::Releasing;
    line.tone = calm ? Tone::Normal : Tone::Attention;
    if (line.stage == StopStage::Sent && stop.unanswered > std::chrono::seconds(1)) line.tone = Tone::Act;
    const bool refused = std::any_of(stop.services.begin(), stop.services.end(),
                                     [](const StopServiceStatus& service) { return service.refused; });
    if (refused) line.tone = Tone::Act;
    const bool taken = !stop.sent || stop.acknowledged || !stop.supported;
    line.releasable = robot.grant.mine && taken && !stop.releasing;
    return line;
}

QStringList stopBriefs() {
    QStringList all;
    StopStatus stop;
    for (const bool known : {false, true}) {
        stop.supported = stop.standingKnown = known;
        for (const StopStage stage :
             {StopStage::Sent, StopStage::Acknowledged, StopStage::Standing, StopStage::Releasing})
            all += briefOf(stage, stop);
    }
    for (const double seconds : {8.8, 88.0, 60.0 * 58.0 + 58.0, 1e9}) all += briefSilence(seconds);
    all.removeDuplicates();
    return all;
}

}  // namespace leitstand
