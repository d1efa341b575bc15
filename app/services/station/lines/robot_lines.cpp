#include "app/services/station/lines/robot_lines.h"

namespace leitstand {
namespace {

BrakeFacts brakeFactsOf(const RobotLine& line, const GrantKeeper& grants, const StopSender& stops) {
    BrakeFacts facts;
    const DriveStreamer* const drive = line.drive();
    if (drive == nullptr) return facts;
    const DriveStatus status = drive->status();
    const std::string& robot = line.robot().name;
    facts.mayDrive = status.focus && grants.mayAct(driveGrant(robot)) && stops.allowsDriving(robot) &&
                     !stops.holdsByZeros(robot);
    facts.listening = status.listeners > 0;
    facts.needsNeutral = status.needsNeutral;
    return facts;
}

}  // namespace

void giveSticks(const RobotLines& lines, const std::string& robot) {
    for (const auto& [name, line] : lines) {
        if (name != robot && line->drive() != nullptr) line->drive()->setFocus(false);
    }
    const auto chosen = lines.find(robot);
    if (chosen != lines.end() && chosen->second->drive() != nullptr) chosen->second->drive()->setFocus(true);
}

StationBrakes::Hands brakeHands(const RobotLines& lines, const GrantKeeper& grants, const StopSender& stops) {
    StationBrakes::Hands hands;
    hands.facts = [&](const std::string& robot) { return brakeFactsOf(*lines.at(robot), grants, stops); };
    hands.spaceAhead = [&](const std::string& robot) { return lines.at(robot)->sight().spaceAhead(); };
    hands.push = [&](const std::string& robot, const DriveVelocity& sticks) {
        // The space ahead was looked at: the age of pictures plays no role.
        if (DriveStreamer* const drive = lines.at(robot)->drive()) drive->set(sticks, true);
    };
    return hands;
}

}  // namespace leitstand
