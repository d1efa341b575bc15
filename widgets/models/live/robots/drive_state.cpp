#include "widgets/models/live/robots/drive_state.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

#include "core/base/time.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "widgets/models/live/robots/proximity.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/live/texts/sight_text.h"
#include "widgets/models/live/texts/stop_line.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct DriveTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::DriveState)
};

const QString Dash(QChar(0x2013));
const QString Degree(QChar(0xb0));

/// Returns the most pressing thing that must be known before the robot moves.
std::pair<QString, Tone> hintOf(const RobotView& robot, const ModeLabel& mode, const StopLine& stop) {
    if (mode.kind == ModeKind::Lost || robot.link.state == LinkState::NeverSeen) {
        const QString reported = stop.stage == StopStage::None
                                     ? mode.reason
                                     : DriveTexts::tr("stop %1 · %2").arg(stop.text, mode.reason);
        return {reported, mode.kind == ModeKind::Lost ? Tone::Attention : Tone::Muted};
    }
    if (stop.stage != StopStage::None) {
        if (!stop.details.isEmpty()) return {stop.text + QStringLiteral(" · ") + stop.details, stop.tone};
        if (stop.stage == StopStage::Standing && stop.releasable)
            return {DriveTexts::tr("standing · hold the button of robot %1 for 1 s to release")
                        .arg(stop.face.letter),
                    Tone::Normal};
        return {stop.text, stop.tone};
    }
    const DriveView& drive = robot.drive;
    if (!drive.drivable) return {DriveTexts::tr("takes no drive commands"), Tone::Muted};
    if (!robot.grant.mine) return {mode.reason, Tone::Muted};
    // Without the sticks nothing is sent, so it is enough that the robot is reachable.
    const bool receives = drive.listening || (!drive.focus && drive.reachable);
    if (!receives) return {DriveTexts::tr("does not hear drive commands"), Tone::Attention};
    if (!drive.focus) {
        const bool busy = mode.kind == ModeKind::Autonomous && !mode.reason.isEmpty();
        return {busy ? mode.reason : DriveTexts::tr("the sticks are not on this robot"), Tone::Muted};
    }
    const SightLine sight = sightLineOf(drive);
    if (drive.sight.overridden || drive.sight.factor <= 0.0) return {sight.text, sight.tone};
    if (drive.needsNeutral) return {DriveTexts::tr("sticks must be neutral first"), Tone::Attention};
    if (!sight.text.isEmpty()) return {sight.text, sight.tone};
    if (!mode.reason.isEmpty()) return {mode.reason, Tone::Muted};
    return {drive.driving ? DriveTexts::tr("you drive") : DriveTexts::tr("ready: you have the sticks"),
            Tone::Muted};
}

void fillMotion(DriveState& state, const RobotDescription& description, const RobotView& robot,
                const RobotState& reported, Time now) {
    state.speed = {Dash, DriveTexts::tr("m/s"), Tone::Muted};
    state.turn = {Dash, DriveTexts::tr("°/s"), Tone::Muted};
    state.nearest = {Dash, DriveTexts::tr("m"), Tone::Muted};
    if (isFresh(reported.odometry, now, 1.0)) {
        const OdometrySample& odometry = reported.odometry->sample;
        const double speed = odometry.linear.x(), turn = inDegrees(odometry.angular.z());
        if (std::isfinite(speed)) state.speed = {numberText(speed, 2), state.speed.unit, Tone::Normal};
        if (std::isfinite(turn)) state.turn = {numberText(turn, 0), state.turn.unit, Tone::Normal};
    }
    if (!robot.around || robot.link.state == LinkState::Lost) return;
    const auto ring = proximityRing(*robot.around, boxAround(description.footprint), robot.drive.velocity);
    const Proximity* nearest = nearestOf(ring);
    if (nearest == nullptr) return;
    // The tone is that of the loudest part, which need not be the nearest.
    const bool touching =
        std::ranges::any_of(ring, [](const Proximity& part) { return part.nearness == Nearness::Touching; });
    const bool near =
        std::ranges::any_of(ring, [](const Proximity& part) { return part.nearness == Nearness::Near; });
    state.nearest = {numberText(nearest->distance, 2), state.nearest.unit,
                     touching ? Tone::Act
                     : near   ? Tone::Attention
                              : Tone::Normal};
}

/// Returns a joint's speed; NaN when it is unknown.
double speedOf(const JointSample& joints, const std::string& name) {
    for (std::size_t i = 0; i < std::min(joints.names.size(), joints.velocities.size()); ++i) {
        if (joints.names[i] == name) return joints.velocities[i];
    }
    return Unknown;
}

TrackFigures tracksOf(const RobotDescription& description, const RobotView& robot) {
    TrackFigures figures;
    if (description.drive != DriveType::Tracked || !robot.joints || robot.jointsAge > 1.0) return figures;
    const double left = speedOf(*robot.joints, "left_track"), right = speedOf(*robot.joints, "right_track");
    if (!std::isfinite(left) || !std::isfinite(right)) return figures;
    const auto [askedLeft, askedRight] = tracksOf(robot.drive.velocity, trackDistance(description));
    // The strip is read at a glance: less than a fifth of the commanded speed counts as standing.
    const auto stuck = [](double asked, double is) { return std::abs(asked) > 0.08 && is / asked < 0.2; };
    const auto pair = [](double is, double asked) {
        return DriveTexts::tr("%1 of %2").arg(numberText(is, 2), numberText(asked, 2));
    };
    figures.text = DriveTexts::tr("chains %1 · %2 m/s").arg(pair(left, askedLeft), pair(right, askedRight));
    figures.brief = DriveTexts::tr("%1 · %2 m/s").arg(pair(left, askedLeft), pair(right, askedRight));
    const bool leftStuck = stuck(askedLeft, left), rightStuck = stuck(askedRight, right);
    if (leftStuck && rightStuck)
        figures.note = DriveTexts::tr("the chains do not follow");
    else if (leftStuck)
        figures.note = DriveTexts::tr("the left chain does not follow");
    else if (rightStuck)
        figures.note = DriveTexts::tr("the right chain does not follow");
    if (!figures.note.isEmpty()) figures.tone = Tone::Attention;
    return figures;
}

AttitudeFigures attitudeOf(const RobotDescription& description, const RobotState& reported, Time now,
                           const AlarmLimits& limits) {
    AttitudeFigures figures;
    figures.maxRoll = description.maxRoll;
    figures.maxPitch = description.maxPitch;
    if (figures.maxRoll > 0.0 && figures.maxPitch > 0.0) {
        const QString roll = numberText(inDegrees(figures.maxRoll), 0) + Degree;
        const QString pitch = numberText(inDegrees(figures.maxPitch), 0) + Degree;
        figures.limits = roll == pitch ? DriveTexts::tr("tips at %1").arg(roll)
                                       : DriveTexts::tr("tips at %1 · %2").arg(roll, pitch);
    }
    const auto angles = rollAndPitch(description, reported, now);
    if (!angles) {
        figures.text = DriveTexts::tr("no attitude");
        figures.tone = Tone::Muted;
        return figures;
    }
    figures.known = true;
    std::tie(figures.roll, figures.pitch) = *angles;
    figures.text = DriveTexts::tr("roll %1 · pitch %2")
                       .arg(numberText(inDegrees(figures.roll), 0) + Degree,
                            numberText(inDegrees(figures.pitch), 0) + Degree);
    const double share = shareOfLimits(description, figures.roll, figures.pitch);
    figures.tone = share >= limits.attitudeAct ? Tone::Act
                   : share >= limits.attitude  ? Tone::Attention
                                               : Tone::Normal;
    return figures;
}

/// Returns the tone of @p value, which should stay above @p look and @p act.
Tone toneBelow(double value, double look, double act) {
    return value <= act ? Tone::Act : value <= look ? Tone::Attention : Tone::Normal;
}

BatteryFigures batteryOf(const RobotState& reported, Time now, const AlarmLimits& limits) {
    BatteryFigures figures;
    figures.charge = {Dash, DriveTexts::tr("%"), Tone::Muted};
    if (!reported.battery) {
        figures.left = DriveTexts::tr("not reported");
        return figures;
    }
    const BatterySample& battery = reported.battery->sample;
    if (std::isfinite(battery.fraction)) {
        figures.fraction = std::clamp(battery.fraction, 0.0, 1.0);
        figures.charge = {numberText(100.0 * figures.fraction, 0), DriveTexts::tr("%"),
                          toneBelow(figures.fraction, limits.batteryShare, limits.batteryShareAct)};
    } else if (std::isfinite(battery.voltage)) {
        figures.charge = {numberText(battery.voltage, 1), DriveTexts::tr("V"), Tone::Normal};
    }
    const double minutes = minutesLeft(reported);
    if (!isFresh(reported.battery, now, BatteryAge)) {
        const double age = toSeconds(now - reported.battery->received);
        figures.left = lossText({.arrival = age});
        figures.charge.tone = Tone::Muted;
    } else if (battery.status == BatterySample::Status::Charging) {
        figures.left = DriveTexts::tr("charging");
        figures.charge.tone = Tone::Normal;
    } else if (std::isfinite(minutes)) {
        figures.leftBrief = minutes < 600.0 ? DriveTexts::tr("%1 min").arg(numberText(minutes, 0))
                                            : DriveTexts::tr("%1 h").arg(numberText(minutes / 60.0, 0));
        figures.left = DriveTexts::tr("%1 at this load").arg(figures.leftBrief);
        const Tone tone = toneBelow(minutes, limits.batteryMinutes, limits.batteryMinutesAct);
        if (tone != Tone::Normal) figures.leftTone = tone;
        figures.charge.tone = std::max(figures.charge.tone, tone);
    }
    if (figures.leftBrief.isEmpty()) figures.leftBrief = figures.left;
    return figures;
}

GasFigures gasOf(const RobotDescription& description, const RobotState& reported, const ValueTrend& trend,
                 Time now, double alarm) {
    GasFigures figures;
    figures.alarm = alarm;
    figures.fitted = reported.gas != nullptr || description.stream(StreamRole::Gas) != nullptr;
    figures.value = {Dash, DriveTexts::tr("ppm"), Tone::Muted};
    if (!figures.fitted) {
        figures.caption = DriveTexts::tr("not fitted");
        return figures;
    }
    figures.samples = trend.samples(now);
    figures.caption = DriveTexts::tr("last 2 min · alarm at %1").arg(numberText(alarm, 0));
    if (!reported.gas || !std::isfinite(reported.gas->sample.ppm)) {
        figures.caption = DriveTexts::tr("no data yet");
        return figures;
    }
    figures.value.value = numberText(reported.gas->sample.ppm, 0);
    if (!isFresh(reported.gas, now, 5.0)) {
        const double age = toSeconds(now - reported.gas->received);
        figures.caption = lossText({.arrival = age});
        return figures;
    }
    figures.value.tone = reported.gas->sample.ppm >= alarm ? Tone::Attention : Tone::Normal;
    const double rise = trend.risePerMinute();
    const double clear = std::max(60.0, 0.1 * reported.gas->sample.ppm);  // above the sensor's own noise
    if (std::abs(rise) > clear) figures.arrow = rise > 0.0 ? QStringLiteral("↑") : QStringLiteral("↓");
    return figures;
}

QStringList linkFigures(const LinkStatus& link) {
    QStringList figures;
    if (link.state != LinkState::Lost && link.state != LinkState::NeverSeen) {
        for (const QString& figure : {roundTripText(link), lossShareText(link)}) {
            if (!figure.isEmpty()) figures << figure;
        }
    }
    return figures.isEmpty() ? QStringList(linkStateText(link.state)) : figures;
}

}  // namespace

GrantFigures grantFiguresOf(const GrantView& grant) {
    using Choice = GrantFigures::Choice;
    const auto titled = [](const std::string& title, const std::string& id) {
        return othersText(title.empty() ? id : title);
    };
    if (grant.mine && !grant.requestedBy.empty()) {
        return {Choice::Answer,
                DriveTexts::tr("%1 requests drive control")
                    .arg(titled(grant.requestedByTitle, grant.requestedBy)),
                Tone::Attention};
    }
    if (grant.mine) return {Choice::GiveUp, DriveTexts::tr("drive control: yours"), Tone::Muted};
    const QString holder = titled(grant.holderTitle, grant.holder);
    if (grant.asked) {
        if (!grant.refusedBy.empty())
            return {Choice::Ask, DriveTexts::tr("%1 keeps it").arg(holder), Tone::Attention};
        return {Choice::Asked,
                holder.isEmpty() ? DriveTexts::tr("requested: listens for others")
                                 : DriveTexts::tr("requested: waits for %1").arg(holder),
                Tone::Normal};
    }
    if (!grant.lostTo.empty())
        return {Choice::Ask, DriveTexts::tr("%1 took over").arg(holder), Tone::Attention};
    if (holder.isEmpty()) return {Choice::Ask, DriveTexts::tr("drive control: free"), Tone::Normal};
    if (grant.silent)
        return {Choice::Ask, DriveTexts::tr("%1 has it, but is silent").arg(holder), Tone::Normal};
    return {Choice::Ask, DriveTexts::tr("%1 drives").arg(holder), Tone::Normal};
}

DriveState driveStateOf(const RobotFace& face, const RobotDescription& description, const RobotView& robot,
                        const RobotState& reported, const ValueTrend& gas, Time now,
                        const AlarmLimits& limits) {
    DriveState state;
    state.face = face;
    state.mode = modeLabelOf(robot, reported.mode);
    std::tie(state.hint, state.hintTone) = hintOf(robot, state.mode, stopLineOf(face, robot));
    fillMotion(state, description, robot, reported, now);
    state.tracks = tracksOf(description, robot);
    state.attitude = attitudeOf(description, reported, now, limits);
    state.battery = batteryOf(reported, now, limits);
    state.link = linkFigures(robot.link);
    state.linkReason = worstReasonText(robot.link);
    state.linkTone = toneOf(robot.link);
    state.gas = gasOf(description, reported, gas, now, limits.gas);
    state.grant = grantFiguresOf(robot.grant);
    if (!robot.drive.drivable) state.grant = {};
    return state;
}

}  // namespace leitstand
