#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/words.h"

/// What our robots report about themselves, as English text on the wire: the reasons of their modes and
/// limits, and their attitude. These fields contain no other text, so that stations can show it in the
/// window's language. "{}" stands for a figure or a name.
namespace leitstand::robot_format {

// About modes and who has the robot.
constexpr auto Started = translatable("leitstand::RobotSays", "started");
constexpr auto AskedFor = translatable("leitstand::RobotSays", "asked for");
constexpr auto CannotBeAskedFor = translatable("leitstand::RobotSays", "{} cannot be asked for");
constexpr auto NoMode = translatable("leitstand::RobotSays", "expected a mode, found \"{}\"");
constexpr auto StopStands = translatable("leitstand::RobotSays", "the stop stands: release it first");
constexpr auto RemoteInUse = translatable("leitstand::RobotSays", "the radio remote is in use");
constexpr auto RemoteLetGo = translatable("leitstand::RobotSays", "the radio remote was let go of");
constexpr auto NoHeatInSight = translatable("leitstand::RobotSays", "no body heat in sight");
constexpr auto HeatInSight = translatable("leitstand::RobotSays", "body heat in sight");
constexpr auto Stop = translatable("leitstand::RobotSays", "stop");
constexpr auto StoppedBy = translatable("leitstand::RobotSays", "stopped by {}");
constexpr auto StoppedByButton = translatable("leitstand::RobotSays", "its own button");
constexpr auto Released = translatable("leitstand::RobotSays", "released");
constexpr auto NeutralFirst = translatable("leitstand::RobotSays", "sticks must be neutral first");
// About the link.
constexpr auto LinkBack = translatable("leitstand::RobotSays", "the link is back");
constexpr auto LinkBackGoesOn = translatable("leitstand::RobotSays", "the link is back: goes on");
constexpr auto LinkBackWaits =
    translatable("leitstand::RobotSays", "the link is back: waits to be asked again");
constexpr auto LinkLostStands = translatable("leitstand::RobotSays", "link lost: stands");
constexpr auto LinkLostFinishes =
    translatable("leitstand::RobotSays", "link lost: finishes what it does, then waits");
constexpr auto LinkLostReturns =
    translatable("leitstand::RobotSays", "link lost: returns to where it was good");
constexpr auto LinkLostFinished = translatable("leitstand::RobotSays", "link lost: finished, waits");
constexpr auto LinkLostWaits = translatable("leitstand::RobotSays", "link lost: waits");
constexpr auto LinkLostIsBack =
    translatable("leitstand::RobotSays", "link lost: is back where it was good, waits");
constexpr auto LinkLostNoWay = translatable("leitstand::RobotSays", "link lost: finds no way back, waits");
constexpr auto BackWhereLinkWasGood = translatable("leitstand::RobotSays", "back where the link was good");
// While it explores or drives to a goal.
constexpr auto ScannerSilent = translatable("leitstand::RobotSays", "the scanner is silent: stands");
constexpr auto LooksAround = translatable("leitstand::RobotSays", "looks around first");
constexpr auto AtTheGoal = translatable("leitstand::RobotSays", "at the goal");
constexpr auto LooksAgain = translatable("leitstand::RobotSays", "finds no way: looks again");
constexpr auto NoWayToTheGoal = translatable("leitstand::RobotSays", "finds no way to the goal");
constexpr auto NothingLeft = translatable("leitstand::RobotSays", "nothing is left to explore");
constexpr auto MakesRoom = translatable("leitstand::RobotSays", "stuck: makes room");
constexpr auto LooksForAWay = translatable("leitstand::RobotSays", "looks for a way");
constexpr auto BacksOut = translatable("leitstand::RobotSays", "ran against something: backs out");
constexpr auto LeansBacksOut = translatable("leitstand::RobotSays", "leans too much: backs out");
constexpr auto NoWayOff = translatable("leitstand::RobotSays", "finds no way off what it ran into");
constexpr auto RolledOverStands = translatable("leitstand::RobotSays", "rolled over: stands");
constexpr auto NoRule = translatable("leitstand::RobotSays", "no rule applies: stands");
// While it drives to a victim.
constexpr auto NoHeat = translatable("leitstand::RobotSays", "no heat to drive to");
constexpr auto HeatLost = translatable("leitstand::RobotSays", "the heat was lost");
constexpr auto HeatHidden = translatable("leitstand::RobotSays", "the heat is hidden from here");
constexpr auto HeatBare =
    translatable("leitstand::RobotSays", "warm, but no person: no clothes beside the heat");
constexpr auto HeatUnreachable = translatable("leitstand::RobotSays", "the heat cannot be reached");
constexpr auto VictimKnown = translatable("leitstand::RobotSays", "that victim is known");
constexpr auto GaveUp = translatable("leitstand::RobotSays", "gave the approach up");
constexpr auto TurnsToHeat = translatable("leitstand::RobotSays", "turns to the heat");
constexpr auto DrivesToHeat = translatable("leitstand::RobotSays", "drives towards the heat");
constexpr auto DrivesAround =
    translatable("leitstand::RobotSays", "drives around what stands before the heat");
constexpr auto MeasuresAgain = translatable("leitstand::RobotSays", "measures again");
constexpr auto HeatAhead = translatable("leitstand::RobotSays", "heat {} m ahead");
constexpr auto AtAVictim = translatable("leitstand::RobotSays", "stands in front of a victim");
constexpr auto BeforeAVictim = translatable("leitstand::RobotSays", "stands {} m in front of a victim");
// Why it is slower than requested.
constexpr auto NoNumber = translatable("leitstand::RobotSays", "the wish is no number");
constexpr auto Obstacle = translatable("leitstand::RobotSays", "obstacle in {} m");
constexpr auto OldScan = translatable("leitstand::RobotSays", "the scan there is {} s old");
constexpr auto NotSeenYet = translatable("leitstand::RobotSays", "not seen there yet");
// Whether it stands upright.
constexpr auto RollOver = translatable("leitstand::RobotSays", "roll-over");
constexpr auto Upright = translatable("leitstand::RobotSays", "upright");
constexpr auto AboutToRollOver = translatable("leitstand::RobotSays", "about to roll over");
constexpr auto RolledOver = translatable("leitstand::RobotSays", "rolled over");

// Where it was touched, and what it saw.
constexpr auto Front = translatable("leitstand::RobotSays", "front");
constexpr auto Left = translatable("leitstand::RobotSays", "left");
constexpr auto Rear = translatable("leitstand::RobotSays", "rear");
constexpr auto Right = translatable("leitstand::RobotSays", "right");
constexpr auto BodyHeat = translatable("leitstand::RobotSays", "body heat, {} degrees C");

// clang-format off
inline constexpr std::array All = {
    Started, AskedFor, CannotBeAskedFor, NoMode, StopStands, RemoteInUse, RemoteLetGo, NoHeatInSight,
    HeatInSight, Stop, StoppedBy, StoppedByButton, Released, NeutralFirst, LinkBack, LinkBackGoesOn, LinkBackWaits,
    LinkLostStands, LinkLostFinishes, LinkLostReturns, LinkLostWaits, LinkLostFinished, LinkLostIsBack,
    LinkLostNoWay, BackWhereLinkWasGood, ScannerSilent, LooksAround, AtTheGoal, LooksAgain,
    NoWayToTheGoal, NothingLeft, MakesRoom, LooksForAWay, BacksOut, LeansBacksOut, NoWayOff,
    RolledOverStands, NoRule, NoHeat, HeatLost, HeatHidden, HeatBare, HeatUnreachable, VictimKnown, GaveUp, TurnsToHeat,
    DrivesToHeat, DrivesAround, MeasuresAgain, HeatAhead, AtAVictim, BeforeAVictim, NoNumber, Obstacle,
    OldScan, NotSeenYet, RollOver, Upright, AboutToRollOver, RolledOver, Front, Left, Rear, Right,
    BodyHeat};
// clang-format on

/// A part of a robot's report.
struct Part {
    const char* words = nullptr;  ///< one of All; null: the text is unknown
    std::string value;            ///< text in place of "{}"; the whole part when the text is unknown
};
/// Splits @p reported at its semicolons: "heat 1.20 m ahead; obstacle in 0.40 m". Never fails: other robots
/// may report anything.
[[nodiscard]] std::vector<Part> partsOf(const std::string& reported);

}  // namespace leitstand::robot_format
