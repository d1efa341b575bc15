#include "widgets/models/live/robots/robot_row.h"

#include <algorithm>
#include <tuple>

#include <QCoreApplication>

namespace leitstand {
namespace {

struct RowTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RobotRow)
};

/// Returns how urgent the state of a link is.
int urgencyOf(LinkState link) {
    switch (link) {
        case LinkState::Connected:
            return 0;
        case LinkState::NeverSeen:
            return 1;
        case LinkState::Degraded:
            return 2;
        case LinkState::Lost:
            return 3;
    }
    return 0;
}

/// Returns how urgent a stop is: by its tone, then one that stands before one that ends.
auto urgencyOf(const StopLine& stop) {
    const bool standing = stop.stage == StopStage::Standing;
    return std::tuple(stop.stage != StopStage::None, static_cast<int>(stop.tone), standing);
}

}  // namespace

RobotRow robotRowOf(int count, int capacity, int first, int selected) {
    RobotRow row;
    const int room = std::clamp(capacity, 1, std::max(1, count));
    int begin = std::clamp(first, 0, count - std::min(room, count));
    int end = std::min(count, begin + room);
    // The selected one takes the slot of the robot at the end where it was scrolled out.
    const bool out = selected >= 0 && selected < count;
    if (out && selected < begin) ++begin;
    if (out && selected >= end) --end;
    for (int i = 0; i < count; ++i) {
        const bool shown = i == selected || (i >= begin && i < end);
        (shown ? row.shown : i < begin ? row.before : row.after).push_back(i);
    }
    return row;
}

int firstToReveal(int robot, int capacity, int first) {
    return std::clamp(first, std::max(0, robot - std::max(1, capacity) + 1), std::max(0, robot));
}

HiddenRobots hiddenRobotsOf(const std::vector<int>& places, const std::vector<RobotChip>& chips,
                            const std::vector<StopLine>& stops) {
    HiddenRobots hidden;
    QStringList details;
    for (const int place : places) {
        const auto i = static_cast<std::size_t>(place);
        if (i >= chips.size()) continue;
        const StopLine stop = i < stops.size() ? stops[i] : StopLine{};
        if (urgencyOf(chips[i].link) > urgencyOf(hidden.link)) hidden.link = chips[i].link;
        if (urgencyOf(stop) > urgencyOf(hidden.stop)) hidden.stop = stop;
        details += robotDetails(chips[i], stop);
        ++hidden.count;
    }
    hidden.details = details.join(QLatin1Char('\n'));
    return hidden;
}

QString robotDetails(const RobotChip& chip, const StopLine& stop) {
    if (stop.stage == StopStage::None) return chip.details;
    return RowTexts::tr("%1 · STOP: %2", "a robot, all of its state, its stop").arg(chip.details, stop.text);
}

}  // namespace leitstand
