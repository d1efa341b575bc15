#include "core/station/alarms/alarm_rules.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/base/known_sentence.h"
#include "core/base/time.h"
#include "core/station/alarms/alarm_format.h"
#include "core/station/robot_figures.h"

namespace leitstand {
namespace {

/// Rounded, and never "-0".
std::string wholeDegrees(double radians) {
    return loggedFigure(std::round(inDegrees(radians)) + 0.0);
}

std::string batteryText(double share, double minutes) {
    const std::string percent = loggedFigure(100.0 * share), left = loggedFigure(minutes);
    if (!std::isfinite(minutes)) return fmt::format(alarm_format::BatteryShare, percent);
    return std::isfinite(share) ? fmt::format(alarm_format::BatteryBoth, percent, left)
                                : fmt::format(alarm_format::BatteryMinutes, left);
}

/// Collects the causes of one robot.
class Judge {
public:
    Judge(const RobotWatch& robot, const AlarmBook& book, Time now, const AlarmLimits& limits)
        : m_robot(robot), m_book(book), m_now(now), m_limits(limits) {}

    [[nodiscard]] std::vector<AlarmCause> all() {
        link();
        if (m_robot.view.link.state != LinkState::Lost) {
            attitude();
            battery();
            gas();
            bump();
            wheels();
            diagnostics();
            pictures();
            clock();
        }
        stop();
        grant();
        return std::move(m_causes);
    }

private:
    using Severity = AlarmSeverity;

    [[nodiscard]] AlarmId idOf(const char* key, const std::string& detail = {}) const {
        return {m_robot.description.name, key, detail};
    }
    void add(AlarmId id, Severity severity, const std::string& text, double value = Unknown,
             const std::string& note = {}) {
        m_causes.push_back(
            {std::move(id), severity, fmt::format("{}: {}", m_robot.description.title, text), value, note});
    }
    /// Returns the severity of @p value, which should stay under @p attention and @p act; empty: none.
    [[nodiscard]] std::optional<Severity> above(const AlarmId& id, double value, double attention,
                                                double act) const {
        const auto standing = m_book.severity(id);
        if (value >= (standing == Severity::Act ? m_limits.over : 1.0) * act) return Severity::Act;
        if (value >= (standing ? m_limits.over : 1.0) * attention) return Severity::Attention;
        return std::nullopt;
    }
    /// Returns the severity of @p value, which should stay over @p attention and @p act; empty: none.
    [[nodiscard]] std::optional<Severity> below(const AlarmId& id, double value, double attention,
                                                double act) const {
        const auto standing = m_book.severity(id);
        if (value <= (standing == Severity::Act ? 1.0 / m_limits.over : 1.0) * act) return Severity::Act;
        if (value <= (standing ? 1.0 / m_limits.over : 1.0) * attention) return Severity::Attention;
        return std::nullopt;
    }

    void link() {
        const LinkStatus& link = m_robot.view.link;
        if (link.state == LinkState::Lost) {
            add(idOf(alarm_key::LinkLost), Severity::Act,
                fmt::format(alarm_format::LinkLost, loggedFigure(link.silence)), link.silence);
        } else if (link.state == LinkState::Degraded) {
            const std::string why = link.reasons.empty() ? "degraded" : toString(link.reasons.front());
            add(idOf(alarm_key::LinkDegraded), Severity::Attention,
                fmt::format(alarm_format::LinkDegraded, why), Unknown, why);
        }
        if (const auto& notReceived = m_robot.view.reception) {
            const std::string what = toString(*notReceived);
            add(idOf(alarm_key::NotReceived), Severity::Attention,
                fmt::format(alarm_format::NotReceived, what), Unknown, what);
        }
    }

    void attitude() {
        const auto angles = rollAndPitch(m_robot.description, m_robot.reported, m_now);
        if (!angles) return;
        const auto [roll, pitch] = *angles;
        const double tilt = std::acos(std::clamp(std::cos(roll) * std::cos(pitch), -1.0, 1.0));
        if (const AlarmId id = idOf(alarm_key::RollOver);
            above(id, tilt, m_limits.rolledOver, m_limits.rolledOver)) {
            return add(id, Severity::Act,
                       fmt::format(alarm_format::RolledOver, loggedFigure(inDegrees(tilt))), tilt);
        }
        const AlarmId id = idOf(alarm_key::Attitude);
        const double share = shareOfLimits(m_robot.description, roll, pitch);
        if (const auto loud = above(id, share, m_limits.attitude, m_limits.attitudeAct)) {
            add(id, *loud,
                fmt::format(alarm_format::Tilted, wholeDegrees(roll), wholeDegrees(pitch),
                            loggedFigure(100.0 * share)),
                share);
        }
    }

    void battery() {
        if (!isFresh(m_robot.reported.battery, m_now, BatteryAge)) return;
        const BatterySample& battery = m_robot.reported.battery->sample;
        if (battery.status == BatterySample::Status::Charging) return;
        const AlarmId id = idOf(alarm_key::Battery);
        const double minutes = minutesLeft(m_robot.reported);
        const auto byTime = std::isfinite(minutes)
                                ? below(id, minutes, m_limits.batteryMinutes, m_limits.batteryMinutesAct)
                                : std::nullopt;
        const auto byShare =
            std::isfinite(battery.fraction)
                ? below(id, battery.fraction, m_limits.batteryShare, m_limits.batteryShareAct)
                : std::nullopt;
        if (!byTime && !byShare) return;
        const Severity loud =
            std::max(byTime.value_or(Severity::Attention), byShare.value_or(Severity::Attention));
        const bool timed = std::isfinite(minutes);
        add(id, loud, batteryText(battery.fraction, minutes), timed ? minutes : battery.fraction,
            timed ? "minutes" : "share");
    }

    void gas() {
        if (!isFresh(m_robot.reported.gas, m_now, 5.0)) return;
        const double ppm = m_robot.reported.gas->sample.ppm;
        const AlarmId id = idOf(alarm_key::Gas);
        if (above(id, ppm, m_limits.gas, std::numeric_limits<double>::infinity()))
            add(id, Severity::Attention, fmt::format(alarm_format::Gas, loggedFigure(ppm)), ppm);
    }

    void bump() {
        if (m_robot.bumpAge && *m_robot.bumpAge < m_limits.bumped) {
            add(idOf(alarm_key::Bump, m_robot.bumper), Severity::Attention,
                fmt::format(alarm_format::Bumped, m_robot.bumper));
        }
    }

    void wheels() {
        if (m_robot.spinning < m_limits.spinning) return;
        add(idOf(alarm_key::WheelsSpin), Severity::Attention,
            fmt::format(alarm_format::WheelsSpin, loggedFigure(m_robot.spinning, 1)), m_robot.spinning);
    }

    void diagnostics() {
        if (!m_robot.reported.diagnostics) return;
        for (const DiagnosticStatus& part : m_robot.reported.diagnostics->sample.statuses) {
            if (part.level != DiagnosticStatus::Level::Error) continue;
            add(idOf(alarm_key::Diagnostics, part.name), Severity::Act,
                fmt::format(alarm_format::Part, part.name, part.message), Unknown, part.message);
        }
    }

    void pictures() {
        for (const CameraView& camera : m_robot.view.cameras) {
            if (!camera.age.isFrozen(m_limits.frozen)) continue;
            add(idOf(alarm_key::FrozenPicture, camera.sensor), Severity::Attention,
                fmt::format(alarm_format::Frozen, camera.sensor, loggedFigure(camera.age.content)),
                camera.age.content);
        }
    }

    void clock() {
        if (!m_robot.view.link.clock) return;
        const ClockStatus& clock = *m_robot.view.link.clock;
        const double ahead = toSeconds(clock.ahead);
        const AlarmId id = idOf(alarm_key::ClockOffset);
        if (!above(id, surelyOff(clock), m_limits.clock, std::numeric_limits<double>::infinity())) return;
        const std::string by = loggedFigure(std::abs(ahead), 1);
        add(id, Severity::Attention,
            ahead > 0.0 ? fmt::format(alarm_format::ClockAhead, by)
                        : fmt::format(alarm_format::ClockBehind, by),
            ahead);
    }

    void stop() {
        const StopStatus& stop = m_robot.view.stop;
        const double waits = toSeconds(stop.unanswered);
        if (!stop.supported || !stop.sent || stop.acknowledged || waits < m_limits.unanswered) return;
        add(idOf(alarm_key::StopUnanswered), Severity::Act,
            fmt::format(alarm_format::StopUnanswered, loggedFigure(waits)), waits);
    }

    void grant() {
        const GrantView& grant = m_robot.view.grant;
        if (grant.lostTo.empty() || grant.mine) return;
        const std::string who = grant.holderTitle.empty() ? grant.lostTo : grant.holderTitle;
        add(idOf(alarm_key::GrantLost), Severity::Attention, fmt::format(alarm_format::GrantLost, who),
            Unknown, who);
    }

    const RobotWatch& m_robot;
    const AlarmBook& m_book;
    const Time m_now;
    const AlarmLimits& m_limits;
    std::vector<AlarmCause> m_causes;
};

}  // namespace

std::vector<AlarmCause> alarmsOf(const RobotWatch& robot, const AlarmBook& book, Time now,
                                 const AlarmLimits& limits) {
    return Judge(robot, book, now, limits).all();
}

}  // namespace leitstand
