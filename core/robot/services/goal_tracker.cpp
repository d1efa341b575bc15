#include "core/robot/services/goal_tracker.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr double FarthestWay = 1e6, LongestTime = 1e6;  // [m], [s]; beyond that it is no figure

double sane(double value, double most) {
    return std::isfinite(value) && value >= 0.0 && value < most ? value
                                                                : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool GoalTracker::hasEnded() const {
    switch (m_view.stage) {
        case GoalStage::Asked:
        case GoalStage::UnderWay:
        case GoalStage::Cancelling:
            return false;
        case GoalStage::None:
        case GoalStage::Arrived:
        case GoalStage::Cancelled:
        case GoalStage::Failed:
        case GoalStage::Refused:
        case GoalStage::Unanswered:
            return true;
    }
    return true;
}

void GoalTracker::asked(const GoalId& goal, SteadyTime now) {
    m_goal = goal;
    m_asked = now;
    m_view = {};
    m_view.stage = GoalStage::Asked;
}

void GoalTracker::answered(const GoalId& goal, bool accepted) {
    if (goal != m_goal || m_view.stage != GoalStage::Asked) return;
    m_view.stage = accepted ? GoalStage::UnderWay : GoalStage::Refused;
}

void GoalTracker::cancelling() {
    if (!hasEnded()) m_view.stage = GoalStage::Cancelling;
}

void GoalTracker::reported(std::span<const Report> goals) {
    const auto ours =
        std::find_if(goals.begin(), goals.end(), [this](const Report& one) { return one.goal == m_goal; });
    if (ours == goals.end() || hasEnded()) return;
    switch (ours->status) {
        case Status::Accepted:
        case Status::Executing:
            if (m_view.stage == GoalStage::Asked) m_view.stage = GoalStage::UnderWay;
            break;
        case Status::Canceling:
            m_view.stage = GoalStage::Cancelling;
            break;
        case Status::Succeeded:
            m_view.stage = GoalStage::Arrived;
            break;
        case Status::Canceled:
            m_view.stage = GoalStage::Cancelled;
            break;
        case Status::Aborted:
            m_view.stage = GoalStage::Failed;
            break;
        case Status::Unknown:
            break;
    }
}

void GoalTracker::progressed(const GoalId& goal, double metres, double seconds, int recoveries) {
    if (goal != m_goal || hasEnded()) return;
    m_view.metresLeft = sane(metres, FarthestWay);
    m_view.secondsLeft = sane(seconds, LongestTime);
    m_view.recoveries = std::max(0, recoveries);
}

bool GoalTracker::isOpen(SteadyTime now) const {
    return !hasEnded() && view(now).stage != GoalStage::Unanswered;
}

NavigationView GoalTracker::view(SteadyTime now) const {
    NavigationView view = m_view;
    if (view.stage == GoalStage::Asked && now - m_asked > Patience) view.stage = GoalStage::Unanswered;
    return view;
}

}  // namespace leitstand
