#include "widgets/models/live/texts/link_text.h"

#include <algorithm>

#include <QCoreApplication>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct LinkTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::LinkStatus)
};

}  // namespace

QString sensorText(const std::string& sensor) {
    if (sensor == "left") return LinkTexts::tr("left", "a camera");
    if (sensor == "right") return LinkTexts::tr("right", "a camera");
    if (sensor == "omni") return LinkTexts::tr("panorama", "a camera");
    if (sensor == "ir") return LinkTexts::tr("infrared", "a camera");
    return othersText(sensor);
}

QString streamText(StreamRole role, const std::string& sensor) {
    const bool camera = role == StreamRole::Picture || role == StreamRole::CameraInfo;
    if (!camera || sensor.empty()) return streamRoleText(role);
    return LinkTexts::tr("%1 %2", "a camera and what it sends: left pictures")
        .arg(sensorText(sensor), streamRoleText(role));
}

QString streamRoleText(StreamRole role) {
    if (const char* const title = streamFacts(role).title)
        return QCoreApplication::translate(StreamTitles, title);
    return QString::fromStdString(toString(role)).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString linkStateText(LinkState state) {
    switch (state) {
        case LinkState::NeverSeen:
            return LinkTexts::tr("not heard yet");
        case LinkState::Connected:
            return LinkTexts::tr("connected");
        case LinkState::Degraded:
            return LinkTexts::tr("degraded");
        case LinkState::Lost:
            return LinkTexts::tr("lost");
    }
    return {};
}

QString linkReasonText(const LinkReason& reason) {
    switch (reason.kind) {
        case LinkReason::Kind::Silent:
            return LinkTexts::tr("silent for %1").arg(secondsText(reason.value));
        case LinkReason::Kind::Stale:
            return LinkTexts::tr("%1 %2 old")
                .arg(streamText(reason.role, reason.sensor), secondsText(reason.value));
        case LinkReason::Kind::Late:
            return LinkTexts::tr("%1 %2 late")
                .arg(streamText(reason.role, reason.sensor), secondsText(reason.value));
        case LinkReason::Kind::Loss:
            return LinkTexts::tr("%1 of %2 lost")
                .arg(percentText(reason.value), streamText(reason.role, reason.sensor));
        case LinkReason::Kind::Slow:
            return LinkTexts::tr("slow: %1").arg(secondsText(reason.value));
        case LinkReason::Kind::NoAnswer:
            return LinkTexts::tr("no answer for %1").arg(secondsText(reason.value));
    }
    return {};
}

QString worstReasonText(const LinkStatus& link) {
    return link.reasons.empty() ? QString() : linkReasonText(link.reasons.front());
}

QString roundTripText(const LinkStatus& link) {
    return link.roundTrip ? secondsText(link.roundTrip->median) : QString();
}

QString lossShareText(const LinkStatus& link) {
    double worst = -1.0;  // unknown in a log
    for (const StreamStatus& stream : link.streams) {
        // A camera that went silent is no loss of the link: its own row and the alarms show it.
        if (!stream.stale && stream.lossRatio > worst) worst = stream.lossRatio;
    }
    return worst < 0.0 ? QString() : LinkTexts::tr("%1 loss").arg(percentText(worst));
}

Tone toneOf(const LinkStatus& link) {
    if (link.state == LinkState::NeverSeen) return Tone::Muted;
    return link.state == LinkState::Connected ? Tone::Normal : Tone::Attention;
}

}  // namespace leitstand
