#include "core/station/alarms/alarm_rules.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/phrases/known_sentence.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/event/status_samples.h"
#include "core/robot/link/link_reasons.h"
#include "core/station/robot_figures.h"

namespace leitstand {
namespace {

/// Sensors may send once a minute; an older number says nothing about now [s].
constexpr double ReadingAge = 90.0;

/// Rounded, and never "-0".
std::string wholeDegrees(double radians) {
    return loggedFigure(std::round(inDegrees(radians)) + 0.0);
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
            readings();
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
    void add(AlarmId id, Severity severity, double value = Unknown, const std::string& note = {},
             std::vector<std::pair<std::string, std::string>> more = {}) {
        m_causes.push_back({std::move(id), severity, value, note, std::move(more)});
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
            add(idOf(alarm_key::LinkLost), Severity::Act, link.silence);
        } else if (link.state == LinkState::Degraded) {
            const std::string why = link.reasons.empty() ? "degraded" : logged(link.reasons.front());
            add(idOf(alarm_key::LinkDegraded), Severity::Attention, Unknown, why);
        }
        if (const auto& notReceived = m_robot.view.reception) {
            add(idOf(alarm_key::NotReceived), Severity::Attention, Unknown, toString(*notReceived));
        }
    }

    void attitude() {
        const auto angles = rollAndPitch(m_robot.description, m_robot.reported, m_now);
        if (!angles) return;
        const auto [roll, pitch] = *angles;
        const double tilt = std::acos(std::clamp(std::cos(roll) * std::cos(pitch), -1.0, 1.0));
        if (const AlarmId id = idOf(alarm_key::RollOver);
            above(id, tilt, m_limits.rolledOver, m_limits.rolledOver)) {
            return add(id, Severity::Act, tilt);
        }
        const AlarmId id = idOf(alarm_key::Attitude);
        const double share = shareOfLimits(m_robot.description, roll, pitch);
        if (const auto loud = above(id, share, m_limits.attitude, m_limits.attitudeAct)) {
            add(id, *loud, share, {},
                {{"roll_degrees", wholeDegrees(roll)}, {"pitch_degrees", wholeDegrees(pitch)}});
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
        add(id, loud, timed ? minutes : battery.fraction, timed ? "minutes" : "share",
            {{"percent",
              std::isfinite(battery.fraction) ? loggedFigure(100.0 * battery.fraction) : "unknown"}});
    }

    void gas() {
        if (!isFresh(m_robot.reported.gas, m_now, 5.0)) return;
        const double ppm = m_robot.reported.gas->sample.ppm;
        const AlarmId id = idOf(alarm_key::Gas);
        if (above(id, ppm, m_limits.gas, std::numeric_limits<double>::infinity()))
            add(id, Severity::Attention, ppm);
    }

    void readings() {
        for (const StreamDescription& stream : m_robot.description.streams) {
            const auto found = m_robot.reported.readings.find(stream.topic);
            if (found == m_robot.reported.readings.end() || !isFresh(found->second, m_now, ReadingAge))
                continue;
            const std::vector<double>& values = found->second->sample.values;
            for (std::size_t i = 0; i < std::min(values.size(), stream.readings.size()); ++i)
                reading(stream.readings[i], values[i]);
        }
    }
    void reading(const ReadingDescription& reading, double value) {
        const AlarmId id = idOf(alarm_key::Reading, reading.title);
        const auto standing = m_book.severity(id);
        const ReadingLevel before = !standing                    ? ReadingLevel::Normal
                                    : *standing == Severity::Act ? ReadingLevel::Act
                                                                 : ReadingLevel::Attention;
        const ReadingLevel level = levelOf(reading.limits, value, before);
        if (level == ReadingLevel::Normal) return;
        add(id, level == ReadingLevel::Act ? Severity::Act : Severity::Attention, value, reading.unit);
    }

    void bump() {
        if (m_robot.bumpAge && *m_robot.bumpAge < m_limits.bumped)
            add(idOf(alarm_key::Bump, m_robot.bumper), Severity::Attention);
    }

    void wheels() {
        if (m_robot.spinning < m_limits.spinning) return;
        add(idOf(alarm_key::WheelsSpin), Severity::Attention, m_robot.spinning);
    }

    void diagnostics() {
        if (!m_robot.reported.diagnostics) return;
        for (const DiagnosticStatus& part : m_robot.reported.diagnostics->sample.statuses) {
            if (part.level != DiagnosticStatus::Level::Error) continue;
            add(idOf(alarm_key::Diagnostics, part.name), Severity::Act, Unknown, part.message);
        }
    }

    void pictures() {
        for (const CameraView& camera : m_robot.view.cameras) {
            if (!camera.age.isFrozen(m_limits.frozen)) continue;
            add(idOf(alarm_key::FrozenPicture, camera.sensor), Severity::Attention, camera.age.content);
        }
    }

    void clock() {
        if (!m_robot.view.link.clock) return;
        const ClockStatus& clock = *m_robot.view.link.clock;
        const double ahead = toSeconds(clock.ahead);
        const AlarmId id = idOf(alarm_key::ClockOffset);
        if (!above(id, surelyOff(clock), m_limits.clock, std::numeric_limits<double>::infinity())) return;
        add(id, Severity::Attention, ahead);
    }

    void stop() {
        const StopStatus& stop = m_robot.view.stop;
        const double waits = toSeconds(stop.unanswered);
        if (!stop.supported || !stop.sent || stop.acknowledged || waits < m_limits.unanswered) return;
        add(idOf(alarm_key::StopUnanswered), Severity::Act, waits);
    }

    void grant() {
        const GrantView& grant = m_robot.view.grant;
        if (grant.lostTo.empty() || grant.mine) return;
        const std::string who = grant.holderTitle.empty() ? grant.lostTo : grant.holderTitle;
        add(idOf(alarm_key::GrantLost), Severity::Attention, Unknown, who);
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
