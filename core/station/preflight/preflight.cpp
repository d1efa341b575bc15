#include "core/station/preflight/preflight.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/time.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

using Kind = PreflightCheck::Kind;
using Verdict = BrakeResult::Verdict;

constexpr double FreshPicture = 1.5;        ///< an older picture is not current [s]
constexpr double LeastHours = 2.0;          ///< that the disk must last
constexpr double UsualLog = 1.5e6;          ///< of both robots, before anything arrives [B/s]
constexpr double Spare = 3.0;               ///< the disk must write this many times what the log needs
constexpr std::chrono::hours BrakeFor(24);  ///< how long a brake test counts

std::string joined(const std::vector<std::string>& words, const char* between = ", ") {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

/// Returns the name by which the operator knows a stream: its topic below the robot's name.
std::string shortName(const RobotDescription& robot, const std::string& topic) {
    const std::string prefix = "/" + robot.name + "/";
    return topic.starts_with(prefix) ? topic.substr(prefix.size()) : topic;
}

/// Collects the checks of one robot, or of the station.
class Page {
public:
    explicit Page(std::vector<PreflightCheck>& checks, std::string robot = {})
        : m_checks(checks), m_robot(std::move(robot)) {}
    void add(Kind kind, CheckState state, std::string detail = {}, double number = 0.0, double other = 0.0) {
        m_checks.push_back({kind, state, m_robot, std::move(detail), number, other});
    }
    void add(const WireComplaint& complaint) {
        add(Kind::Wire, CheckState::Attention);
        newest().wire = complaint;
    }
    [[nodiscard]] PreflightCheck& newest() { return m_checks.back(); }

private:
    std::vector<PreflightCheck>& m_checks;
    std::string m_robot;
};

/// False when the robot is not there and nothing more can be judged.
bool judgeLink(Page& page, const LinkStatus& link) {
    if (link.state == LinkState::NeverSeen || link.state == LinkState::Lost) {
        page.add(Kind::RobotMissing, CheckState::Fail, {}, link.silence);
        return false;
    }
    const bool good = link.state == LinkState::Connected;
    page.add(Kind::RobotConnected, good ? CheckState::Ok : CheckState::Attention, {},
             link.roundTrip ? link.roundTrip->median : 0.0);
    page.newest().reasons = link.reasons;
    return true;
}

void judgeStreams(Page& page, const RobotFacts& facts) {
    std::vector<std::string> missing, stale, old;
    int coming = 0;
    double oldest = 0.0;
    bool pictures = false;
    for (const StreamStatus& stream : facts.view.link.streams) {
        if (stream.paused) continue;
        const std::string name = shortName(facts.robot, stream.topic);
        if (stream.samples > 0) ++coming;
        if (streamFacts(stream.role).picture) {
            pictures = true;
            if (!(stream.age <= FreshPicture)) old.push_back(name);
            oldest = std::max(oldest, stream.age);
        } else if (stream.samples == 0) {
            // Streams that come on change, or only from a robot with that part, need not have arrived.
            if (streamFacts(stream.role).needed) missing.push_back(name);
        } else if (stream.stale) {
            stale.push_back(name);
        }
    }
    if (!missing.empty()) page.add(Kind::StreamsMissing, CheckState::Attention, joined(missing));
    if (!stale.empty()) page.add(Kind::StreamsStale, CheckState::Attention, joined(stale));
    if (missing.empty() && stale.empty()) page.add(Kind::StreamsComing, CheckState::Ok, {}, coming);
    if (!old.empty()) {
        page.add(Kind::PicturesOld, CheckState::Fail, joined(old), oldest);
    } else if (pictures) {
        page.add(Kind::PicturesFresh, CheckState::Ok, {}, oldest);
    }
}

void judgeScanners(Page& page, const RobotFacts& facts) {
    if (!facts.view.unplaced.empty())
        page.add(Kind::ScannerUnplaced, CheckState::Attention, joined(facts.view.unplaced));
}

void judgeClock(Page& page, const LinkStatus& link, double limit) {
    if (!link.clock) return page.add(Kind::ClockUnknown, CheckState::Attention);
    const double ahead = toSeconds(link.clock->ahead);
    const bool far = surelyOff(*link.clock) >= limit;
    page.add(far ? Kind::ClockFar : Kind::ClockSteady, far ? CheckState::Attention : CheckState::Ok, {},
             ahead);
}

void judgeDriving(Page& page, const RobotFacts& facts) {
    const RobotView& view = facts.view;
    if (!view.drive.drivable) return;
    if (!view.drive.reachable) page.add(Kind::Deaf, CheckState::Fail);
    if (facts.robot.stream(StreamRole::StopCommand) == nullptr) page.add(Kind::NotBound, CheckState::Note);
    if (const StreamDescription* const lock = facts.robot.stream(StreamRole::StopLock)) {
        const bool heard = view.stop.lockHeard;
        page.add(heard ? Kind::LockHeard : Kind::LockUnheard, heard ? CheckState::Ok : CheckState::Attention,
                 lock->topic);
    }
    std::vector<std::string> offered, missing;
    for (const StopServiceStatus& service : view.stop.services)
        (service.offered ? offered : missing).push_back(service.title);
    if (!offered.empty()) page.add(Kind::StopServices, CheckState::Ok, joined(offered));
    if (!missing.empty()) page.add(Kind::StopServicesMissing, CheckState::Attention, joined(missing));
    if (view.stop.stopped) page.add(Kind::Stopped, CheckState::Attention);
    if (view.grant.mine) {
        page.add(Kind::Grant, CheckState::Ok);
    } else if (view.grant.holder.empty()) {
        page.add(Kind::GrantFree, CheckState::Ok);
    } else {
        const std::string& who = view.grant.holderTitle.empty() ? view.grant.holder : view.grant.holderTitle;
        page.add(Kind::GrantOthers, CheckState::Attention, who);
    }
}

void judgeBrake(Page& page, const RobotFacts& facts, Time now) {
    if (!facts.view.drive.drivable) return;
    const BrakeResult& brake = facts.brake;
    switch (brake.verdict) {
        case Verdict::Untested:
            return page.add(Kind::BrakeUntested, CheckState::Attention);
        case Verdict::Inconclusive:
            page.add(Kind::BrakeUnclear, CheckState::Attention);
            page.newest().brake = brake;
            return;
        case Verdict::Failed:
            page.add(facts.brakeOverridden ? Kind::BrakeOverridden : Kind::BrakeFailed,
                     facts.brakeOverridden ? CheckState::Attention : CheckState::Fail, {}, brake.seconds,
                     brake.metres);
            page.newest().brake = brake;
            page.newest().guard = facts.guard;
            if (facts.brakeOverridden && facts.guard.state == GuardView::State::Failed)
                page.newest().state = CheckState::Fail;
            return;
        case Verdict::Passed:
            break;
    }
    const bool old = now - brake.when > BrakeFor;
    page.add(old ? Kind::BrakeOld : Kind::BrakePassed, old ? CheckState::Attention : CheckState::Ok, {},
             brake.seconds, brake.metres);
    page.newest().brake = brake;
}

void judgeRobot(std::vector<PreflightCheck>& checks, const RobotFacts& facts, Time now, double farClock) {
    Page page(checks, facts.robot.name);
    const bool there = judgeLink(page, facts.view.link);
    for (const WireComplaint& complaint : facts.complaints) page.add(complaint);
    if (!there) return;
    judgeStreams(page, facts);
    judgeScanners(page, facts);
    judgeClock(page, facts.view.link, farClock);
    judgeDriving(page, facts);
    judgeBrake(page, facts, now);
}

void judgeNetwork(Page& page, const PreflightFacts& facts) {
    std::vector<std::string> used;
    bool own = false;
    for (const NetworkCard& card : facts.cards) {
        if (!card.used || !card.up) continue;
        used.push_back(card.name + " " + card.address);
        own = own || !card.loopback;
    }
    page.add(own ? Kind::Network : Kind::NetworkNone, own ? CheckState::Ok : CheckState::Attention,
             joined(used));
    if (!facts.environment.empty()) page.add(Kind::Environment, CheckState::Note, joined(facts.environment));
    for (const std::string& limit : facts.limits) page.add(Kind::Limits, CheckState::Attention, limit);
    for (const WireComplaint& complaint : facts.complaints) page.add(complaint);
    for (const std::string& robot : facts.strangers) page.add(Kind::Stranger, CheckState::Note, robot);
}

void judgeDisk(Page& page, const PreflightFacts& facts) {
    if (!facts.logProblem.empty()) return page.add(Kind::DiskBroken, CheckState::Fail, facts.logProblem);
    const double needed = std::max(facts.logRate, UsualLog);
    const double hours = static_cast<double>(facts.freeBytes) / needed / 3600.0;
    const double rate = facts.writeRate.value_or(0.0);
    if (hours < LeastHours) {
        page.add(Kind::DiskShort, hours < 0.25 ? CheckState::Fail : CheckState::Attention, facts.folder,
                 hours);
    } else if (facts.writeRate && rate < Spare * needed) {
        page.add(Kind::DiskSlow, rate < needed ? CheckState::Fail : CheckState::Attention, facts.folder, rate,
                 needed);
    } else {
        page.add(Kind::Disk, CheckState::Ok, facts.folder, hours, rate);
    }
}

}  // namespace

std::vector<PreflightCheck> preflight(const PreflightFacts& facts) {
    std::vector<PreflightCheck> checks;
    for (const RobotFacts& robot : facts.robots) judgeRobot(checks, robot, facts.now, facts.farClock);
    Page page(checks);
    judgeNetwork(page, facts);
    judgeDisk(page, facts);
    const bool pad = !facts.gamepad.empty();
    page.add(pad ? Kind::Gamepad : Kind::GamepadNone, pad ? CheckState::Ok : CheckState::Note, facts.gamepad);
    const bool audible = facts.soundProblem.empty();
    page.add(audible ? Kind::Sound : Kind::SoundNone, audible ? CheckState::Ok : CheckState::Attention,
             facts.soundProblem);
    page.add(facts.secured ? Kind::Secured : Kind::Open, facts.secured ? CheckState::Ok : CheckState::Note,
             facts.security);
    page.add(Kind::Versions, CheckState::Ok, joined(facts.versions));
    return checks;
}

CheckState worstOf(const std::vector<PreflightCheck>& checks) {
    CheckState worst = CheckState::Ok;
    for (const PreflightCheck& check : checks) worst = std::max(worst, check.state);
    return worst;
}

}  // namespace leitstand
