#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/live/preflight/preflight_list.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

using Kind = PreflightCheck::Kind;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::PreflightList)
};

QString megabytes(double bytesPerSecond) {
    return Words::tr("%1 MB/s").arg(numberText(bytesPerSecond / 1e6, bytesPerSecond < 1e7 ? 1 : 0));
}

QString standing(const PreflightCheck& check) {
    const QString after = secondsText(check.number), way = numberText(100.0 * check.other, 0);
    if (check.brake.brakesAfter > 0.0)
        return Words::tr("brakes after %1, stands after %2 and %3 cm")
            .arg(secondsText(check.brake.brakesAfter), after, way);
    return Words::tr("stands after %1 and %2 cm").arg(after, way);
}

QString reasonsText(const std::vector<LinkReason>& reasons) {
    QStringList texts;
    for (const LinkReason& reason : reasons) texts += linkReasonText(reason);
    return texts.join(QStringLiteral(", "));
}

QString causeText(const BrakeResult& result) {
    using Cause = BrakeResult::Cause;
    switch (result.cause) {
        case Cause::None:
            break;
        case Cause::KeyLetGo:
            return Words::tr("the key was let go");
        case Cause::NotDriven:
            return Words::tr("the robot was not to be driven any more");
        case Cause::RoomUnknown:
            return Words::tr("nothing tells whether there is room ahead");
        case Cause::NoRoom:
            return Words::tr("only %1 m are free ahead, %2 m are needed")
                .arg(numberText(result.free, 1), numberText(result.needed, 1));
        case Cause::NotAllowed:
            return Words::tr("the station may not drive the robot");
        case Cause::Deaf:
            return Words::tr("the robot hears no drive commands");
        case Cause::NoOdometry:
            return Words::tr("no odometry comes");
        case Cause::SticksHeld:
            return Words::tr("the sticks were not let go");
        case Cause::NotStanding:
            return Words::tr("the robot did not stand");
        case Cause::TooSlow:
            return Words::tr("the robot did not come to its speed");
        case Cause::OdometryEnded:
            return Words::tr("no odometry came after the cut");
    }
    return Words::tr("nothing tells why");
}

QString hours(double count) {
    return count < 1.0 ? Words::tr("%1 min").arg(numberText(60.0 * count, 0))
                       : Words::tr("%1 h").arg(numberText(count, 0));
}

QString clockText(const PreflightCheck& check) {
    const QString by = secondsText(std::abs(check.number));
    return check.number < 0.0 ? Words::tr("clock %1 behind ours").arg(by)
                              : Words::tr("clock %1 ahead of ours").arg(by);
}

/// Returns what a robot that failed does when commands stop.
QString failureText(const PreflightCheck& check) {
    if (check.brake.watchdog == BrakeResult::Watchdog::Stops) return standing(check);
    return check.number > 0.0
               ? Words::tr("still moves %1 after the last command").arg(secondsText(check.number))
               : Words::tr("moves without commands");
}

QString guardText(const GuardView& guard) {
    switch (guard.state) {
        case GuardView::State::None:
            break;
        case GuardView::State::Starting:
            return Words::tr("its guard is not heard by it yet");
        case GuardView::State::Ready:
            return Words::tr("its guard stands by");
        case GuardView::State::Failed:
            return Words::tr("no guard: %1").arg(othersText(guard.problem));
    }
    return {};
}

}  // namespace

QString checkText(const PreflightCheck& check) {
    QString detail = othersText(check.detail);
    switch (check.kind) {
        case Kind::RobotConnected:
            if (!check.reasons.empty()) return Words::tr("connected, but %1").arg(reasonsText(check.reasons));
            return check.number > 0.0 ? Words::tr("connected, round trip %1").arg(secondsText(check.number))
                                      : Words::tr("connected");
        case Kind::RobotMissing:
            return std::isfinite(check.number) ? Words::tr("silent for %1").arg(secondsText(check.number))
                                               : Words::tr("not heard yet");
        case Kind::StreamsComing:
            return Words::tr("%1 streams come").arg(countText(static_cast<std::size_t>(check.number)));
        case Kind::StreamsMissing:
            return Words::tr("never came: %1").arg(detail);
        case Kind::StreamsStale:
            return Words::tr("do not come any more: %1").arg(detail);
        case Kind::ScannerUnplaced:
            return Words::tr("nobody tells where %1 sits: it counts as sitting at the robot's base")
                .arg(detail);
        case Kind::PicturesFresh:
            return Words::tr("camera pictures are fresh");
        case Kind::PicturesOld:
            return Words::tr("no fresh pictures: %1").arg(detail);
        case Kind::ClockSteady:
        case Kind::ClockFar:
            return clockText(check);
        case Kind::ClockUnknown:
            return Words::tr("its clock is not known yet");
        case Kind::Grant:
            return Words::tr("this station may drive it");
        case Kind::GrantFree:
            return Words::tr("drive control is free");
        case Kind::GrantOthers:
            return Words::tr("%1 has drive control").arg(detail);
        case Kind::Deaf:
            return Words::tr("hears no drive commands");
        case Kind::NotBound:
            return Words::tr("STOP is a zero command: it has no stop of its own, and obeys others, too");
        case Kind::LockHeard:
            return Words::tr("STOP also locks %1").arg(detail);
        case Kind::LockUnheard:
            return Words::tr("nobody listens to %1: STOP does not hold off what others send").arg(detail);
        case Kind::StopServices:
            return Words::tr("STOP also calls %1").arg(detail);
        case Kind::StopServicesMissing:
            return Words::tr("nobody offers %1: STOP cannot call it").arg(detail);
        case Kind::Stopped:
            return Words::tr("stopped");
        case Kind::BrakePassed:
            return Words::tr("brake: %1 without commands").arg(standing(check));
        case Kind::BrakeOld:
            return Words::tr("brake: tested more than a day ago, %1").arg(standing(check));
        case Kind::BrakeUntested:
            return Words::tr("brake: not tested");
        case Kind::BrakeFailed:
            return Words::tr("brake: FAILED, %1; driving is refused").arg(failureText(check));
        case Kind::BrakeOverridden: {
            const QString guard = guardText(check.guard);
            return guard.isEmpty() ? Words::tr("brake: FAILED, and driven nevertheless")
                                   : Words::tr("brake: FAILED, and driven nevertheless; %1").arg(guard);
        }
        case Kind::BrakeUnclear:
            return Words::tr("brake: no result (%1)").arg(causeText(check.brake));
        case Kind::Wire: {
            const QString complaint = othersText(worded(check.wire));
            return complaint.isEmpty() ? detail : complaint;
        }
        case Kind::Limits:
        case Kind::Versions:
        case Kind::Secured:
        case Kind::SoundNone:
            return detail;
        case Kind::Open:
            return Words::tr("not secured: anybody in the network may speak");
        case Kind::Stranger:
            return Words::tr("robot \"%1\" is heard, and not driven").arg(detail);
        case Kind::Network:
            return Words::tr("network: %1").arg(detail);
        case Kind::NetworkNone:
            return Words::tr("network: this computer only");
        case Kind::Environment:
            return Words::tr("network set by ROS's environment: %1").arg(detail);
        case Kind::Disk:
            return check.other > 0.0 ? Words::tr("disk: room for %1, writes %2")
                                           .arg(hours(check.number), megabytes(check.other))
                                     : Words::tr("disk: room for %1").arg(hours(check.number));
        case Kind::DiskSlow:
            return Words::tr("disk: writes only %1, the log needs %2")
                .arg(megabytes(check.number), megabytes(check.other));
        case Kind::DiskShort:
            return Words::tr("disk: room for %1 only").arg(hours(check.number));
        case Kind::DiskBroken:
            return Words::tr("nothing is recorded: %1").arg(detail);
        case Kind::Gamepad:
            return Words::tr("gamepad: %1").arg(detail);
        case Kind::GamepadNone:
            return Words::tr("no gamepad: keys drive");
        case Kind::Sound:
            return Words::tr("sound: there is a device; try the tones");
    }
    return detail;
}

QString remedyText(const PreflightCheck& check) {
    if (check.state <= CheckState::Note) {
        return check.kind == Kind::Stranger ? Words::tr("Add it below") : QString();
    }
    switch (check.kind) {
        case Kind::RobotMissing:
            return Words::tr("Is it on, in this network, and in this domain?");
        case Kind::RobotConnected:
            return Words::tr("Come nearer, or thin the link (T)");
        case Kind::StreamsMissing:
        case Kind::StreamsStale:
            return Words::tr("Is the sensor on? Does the robot's file name its topic?");
        case Kind::ScannerUnplaced:
            return Words::tr("Publish its transform (tf_static), or enter its place in the robot's file");
        case Kind::PicturesOld:
            return Words::tr("Is the camera on? Its driver may hang");
        case Kind::Wire:
            return Words::tr("Change the QoS in the robot's file");
        case Kind::ClockFar:
            return Words::tr("It may drop every drive command as too old: set its clock (NTP)");
        case Kind::ClockUnknown:
            return Words::tr("Wait a moment");
        case Kind::GrantOthers:
            return Words::tr("Ask for it when you want to drive (F2)");
        case Kind::Deaf:
            return Words::tr("Is its drive node running? Right topic and type?");
        case Kind::Stopped:
            return Words::tr("Release it: hold its handle beside STOP");
        case Kind::BrakeOld:
        case Kind::BrakeUntested:
        case Kind::BrakeUnclear:
            return Words::tr("Test it: hold the button below");
        case Kind::BrakeFailed:
            return Words::tr("Give it a watchdog, test again, or drive it nevertheless");
        case Kind::BrakeOverridden:
            return Words::tr("Lost radio means a robot that goes on");
        case Kind::NetworkNone:
            return Words::tr("Plug the cable in, or choose --interface");
        case Kind::DiskSlow:
        case Kind::DiskShort:
        case Kind::DiskBroken:
            return Words::tr("Make room, or record elsewhere (--mission)");
        case Kind::SoundNone:
            return Words::tr("Plug in a loudspeaker, then try the tones");
        case Kind::StreamsComing:
        case Kind::PicturesFresh:
        case Kind::ClockSteady:
        case Kind::NotBound:
        case Kind::LockHeard:
        case Kind::LockUnheard:
        case Kind::StopServices:
        case Kind::StopServicesMissing:
        case Kind::Grant:
        case Kind::GrantFree:
        case Kind::BrakePassed:
        case Kind::Stranger:
        case Kind::Network:
        case Kind::Environment:
        case Kind::Limits:
        case Kind::Disk:
        case Kind::Gamepad:
        case Kind::GamepadNone:
        case Kind::Sound:
        case Kind::Secured:
        case Kind::Open:
        case Kind::Versions:
            break;
    }
    return {};
}

QString stateMark(CheckState state) {
    switch (state) {
        case CheckState::Ok:
            return QStringLiteral("✓");
        case CheckState::Note:
            return QStringLiteral("–");
        case CheckState::Attention:
            return QStringLiteral("!");
        case CheckState::Fail:
            break;
    }
    return QStringLiteral("✗");
}

QString stateText(CheckState state) {
    if (state == CheckState::Ok) return Words::tr("in order");
    if (state == CheckState::Note) return Words::tr("to know");
    return state == CheckState::Fail ? Words::tr("must be mended") : Words::tr("needs a look");
}

Tone toneOf(CheckState state) {
    if (state <= CheckState::Note) return Tone::Muted;
    return state == CheckState::Fail ? Tone::Act : Tone::Attention;
}

QString verdictText(const std::vector<PreflightCheck>& checks) {
    const auto count = [&](CheckState state) {
        return std::count_if(checks.begin(), checks.end(),
                             [&](const PreflightCheck& one) { return one.state == state; });
    };
    const auto fails = count(CheckState::Fail), looks = count(CheckState::Attention);
    QStringList parts;
    if (fails > 0) parts += Words::tr("%1 to be mended").arg(fails);
    if (looks > 0) parts += Words::tr("%1 to be looked at").arg(looks);
    return parts.isEmpty() ? Words::tr("All in order") : parts.join(QStringLiteral(", "));
}

QString brakeText(BrakeTest::Phase phase, const BrakeResult& result) {
    switch (phase) {
        case BrakeTest::Phase::Neutral:
            return Words::tr("Waits for drive control and standing ... keep holding");
        case BrakeTest::Phase::Driving:
            return Words::tr("Drives ... keep holding");
        case BrakeTest::Phase::Cut:
            return Words::tr("Says nothing more, and measures ...");
        case BrakeTest::Phase::Idle:
        case BrakeTest::Phase::Done:
            break;
    }
    PreflightCheck check;
    check.number = result.seconds;
    check.other = result.metres;
    check.brake = result;
    switch (result.verdict) {
        case BrakeResult::Verdict::Untested:
            return Words::tr("0.6 m must be free ahead");
        case BrakeResult::Verdict::Passed:
            return Words::tr("Passed: %1").arg(standing(check));
        case BrakeResult::Verdict::Failed:
            return Words::tr("FAILED: %1").arg(failureText(check));
        case BrakeResult::Verdict::Inconclusive:
            return Words::tr("No result: %1").arg(causeText(result));
    }
    return {};
}

}  // namespace leitstand
