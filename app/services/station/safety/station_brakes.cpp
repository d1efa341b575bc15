#include "app/services/station/safety/station_brakes.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "app/services/log/sequencer.h"
#include "core/base/time.h"
#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/io/robot/brake_file.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;
using Verdict = BrakeResult::Verdict;

constexpr milliseconds LooksAhead(200);  ///< how often the space ahead is computed
constexpr milliseconds SilentFor(400);   ///< after the last step; look() is called five times a second

std::int64_t count(SteadyTime time) {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch()).count();
}

}  // namespace

StationBrakes::StationBrakes(const std::vector<RobotDescription>& robots, std::filesystem::path file,
                             Hands hands)
    : m_file(std::move(file)), m_hands(std::move(hands)) {
    const auto remembered = readBrakes(m_file);
    for (const RobotDescription& robot : robots) {
        Entry& entry = m_entries[robot.name];
        if (const auto known = remembered.find(robot.name); known != remembered.end())
            entry.last = known->second;
        judge(entry);
    }
}

StationBrakes::Entry* StationBrakes::find(const std::string& robot) {
    const auto found = m_entries.find(robot);
    return found == m_entries.end() ? nullptr : &found->second;
}

const StationBrakes::Entry* StationBrakes::find(const std::string& robot) const {
    const auto found = m_entries.find(robot);
    return found == m_entries.end() ? nullptr : &found->second;
}

void StationBrakes::begin(const std::string& robot) {
    Entry* const entry = find(robot);
    if (entry == nullptr) return;
    {
        const std::lock_guard lock(m_mutex);
        entry->test.start(steadyNow());
        entry->spaceAt = {};
        entry->running = true;
        entry->overridden = false;
    }
    m_hands.focus(robot, true);
    look(robot);
}

void StationBrakes::hold(const std::string& robot) {
    Entry* const entry = find(robot);
    if (entry == nullptr || !entry->running) return;
    {
        const std::lock_guard lock(m_mutex);
        entry->test.hold(steadyNow());
    }
    look(robot);
}

void StationBrakes::end(const std::string& robot) {
    Entry* const entry = find(robot);
    if (entry == nullptr || !entry->running) return;
    {
        const std::lock_guard lock(m_mutex);
        if (entry->test.phase() != BrakeTest::Phase::Cut) entry->test.end(BrakeResult::Cause::KeyLetGo);
    }
    look(robot);
}

void StationBrakes::onEvent(const Event& event) {
    const auto* odometry = event.sample.as<OdometrySample>();
    Entry* const entry = odometry == nullptr ? nullptr : find(event.robot);
    if (entry == nullptr || !entry->running) return;
    {
        const std::lock_guard lock(m_mutex);
        entry->test.odometry(odometry->header.stamp, odometry->baseInOdom.translation().head<2>(),
                             std::hypot(odometry->linear.x(), odometry->linear.y()), odometry->angular.z());
    }
    look(event.robot);
}

void StationBrakes::look(const std::string& robot) {
    Entry* const entry = find(robot);
    if (entry != nullptr && entry->running) step(robot, *entry);
}

void StationBrakes::step(const std::string& robot, Entry& entry) {
    std::optional<BrakeResult> over;
    {
        // Locked to the end, so that the steps of two threads do not undo each other.
        const std::lock_guard lock(m_mutex);
        if (!entry.running) return;
        const SteadyTime now = steadyNow();
        BrakeFacts facts = m_hands.facts(robot);
        if (entry.test.phase() == BrakeTest::Phase::Neutral && now - entry.spaceAt > LooksAhead) {
            entry.space = m_hands.spaceAhead(robot);
            entry.spaceAt = now;
        }
        facts.spaceAhead = entry.space;
        const BrakeTest::Step step = entry.test.step(facts, now);
        entry.silentUntil = step.silent ? count(now + SilentFor) : 0;
        if (!step.silent) m_hands.push(robot, step.sticks);
        if (!entry.test.isRunning()) {
            over = entry.test.result();
            over->when = stationTime();
            // Whoever sees that it ended finds its result.
            keep(entry, *over);
            entry.running = false;
        }
    }
    m_hands.refresh(robot);
    if (!over) return;
    m_hands.focus(robot, false);
    finish(robot, *over);
}

void StationBrakes::keep(Entry& entry, const BrakeResult& result) {
    // An inconclusive test does not take back a failure.
    const bool proved = result.verdict != Verdict::Inconclusive;
    if (proved || entry.last.verdict != Verdict::Failed) entry.last = result;
    judge(entry);
}

void StationBrakes::judge(Entry& entry) {
    entry.refused = entry.last.verdict == Verdict::Failed;
    entry.unwatched = entry.last.showsNoWatchdog();
}

void StationBrakes::finish(const std::string& robot, const BrakeResult& result) {
    std::map<std::string, BrakeResult> all;
    {
        const std::lock_guard lock(m_mutex);
        for (const auto& [name, one] : m_entries) all.emplace(name, one.last);
    }
    // Robots that the station does not drive today keep their results.
    for (const auto& known : readBrakes(m_file)) all.insert(known);
    m_hands.done(robot, result, writeBrakes(m_file, all));
}

BrakeTest::Phase StationBrakes::phase(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const Entry* const entry = find(robot);
    return entry == nullptr ? BrakeTest::Phase::Idle : entry->test.phase();
}

BrakeResult StationBrakes::result(const std::string& robot) const {
    const std::lock_guard lock(m_mutex);
    const Entry* const entry = find(robot);
    return entry == nullptr ? BrakeResult{} : entry->last;
}

void StationBrakes::setOverridden(const std::string& robot, bool on) {
    if (Entry* const entry = find(robot)) entry->overridden = on;
    m_hands.refresh(robot);
}

bool StationBrakes::isOverridden(const std::string& robot) const {
    const Entry* const entry = find(robot);
    return entry != nullptr && entry->refused && entry->overridden;
}

bool StationBrakes::isRunning(const std::string& robot) const {
    const Entry* const entry = find(robot);
    return entry != nullptr && entry->running;
}

bool StationBrakes::refuses(const std::string& robot) const {
    const Entry* const entry = find(robot);
    return entry != nullptr && entry->refused && !entry->overridden && !entry->running;
}

bool StationBrakes::needsGuard(const std::string& robot) const {
    const Entry* const entry = find(robot);
    return entry != nullptr && entry->unwatched && entry->overridden && !entry->running;
}

bool StationBrakes::silences(const std::string& robot) const {
    const Entry* const entry = find(robot);
    return entry != nullptr && count(steadyNow()) < entry->silentUntil;
}

}  // namespace leitstand
