#pragma once

#include <array>
#include <string>

#include "core/base/words.h"

/// The reasons why a robot's pose in the map is certain or not. They are English in the log
/// (RobotPlaceSample::how), and in the window's language where they are shown. "{}" stands for a figure, a
/// name or another reason.
namespace leitstand::placement_format {

constexpr auto TooFewPoints = translatable("leitstand::Station", "its laser sees too little: {} points");
constexpr auto TooLittle = translatable("leitstand::Station", "its laser sees too little");
constexpr auto LittleInMap = translatable("leitstand::Station", "too little of what it sees is in the map");
constexpr auto OnlyInMap = translatable("leitstand::Station", "only {} % of what it sees is in the map");
constexpr auto InMap = translatable("leitstand::Station", "{} % of what it sees is in the map");
constexpr auto LaserInMap = translatable("leitstand::Station", "{} % of what its laser sees is in the map");
constexpr auto Because = translatable("leitstand::Station", "{}: {}");
constexpr auto FromGuess = translatable(
    "leitstand::Station", "{} % of what it sees is in the map, {} cm and {} degrees from the guess");
constexpr auto DirectionOpen = translatable("leitstand::Station", "the walls leave a direction open");
constexpr auto Elsewhere = translatable("leitstand::Station", "it could as well stand elsewhere");
constexpr auto FarFromTracks =
    translatable("leitstand::Station", "its laser fits {} cm from where its tracks say");
constexpr auto FoundAgain = translatable("leitstand::Station", "found again: {}");
constexpr auto SeenBy =
    translatable("leitstand::Station", "{} sees it: {} % of what its laser sees there is in the map");
constexpr auto AgainstMap = translatable("leitstand::Station", "it would see things where the map has none");
constexpr auto PutBlindly =
    translatable("leitstand::Station", "put there by the operator; its laser says nothing");
constexpr auto PutUntilScan =
    translatable("leitstand::Station", "put there by the operator; its next scan tells where it stands");
constexpr auto FoundByScan = translatable(
    "leitstand::Station",
    "found in the whole map, where {} % of what it sees fits; its next scan tells whether it stands there");
constexpr auto PutBut = translatable("leitstand::Station", "put there by the operator, but {}");
constexpr auto WhereLeftBut =
    translatable("leitstand::Station", "where it was when the station was left: {}");
constexpr auto WhereLeft = translatable("leitstand::Station", "where it was when the station was left");
constexpr auto FitsMap = translatable("leitstand::Station", "its scan fits the map");
constexpr auto OwnPart =
    translatable("leitstand::Station", "it maps a part of its own, which has not met the rest yet");
constexpr auto DoesNotFit = translatable("leitstand::Station", "its scan does not fit");
constexpr auto NewestKeyScan = translatable("leitstand::Station", "its newest key scan");
constexpr auto OdometryRestarted = translatable("leitstand::Station", "its odometry began anew");

/// The most specific first.
inline constexpr auto All = std::to_array<const char*>(
    {FoundByScan, FoundAgain,   PutBut,    WhereLeftBut,      SeenBy,        TooFewPoints, FromGuess,
     TooLittle,   LittleInMap,  OnlyInMap, FarFromTracks,     DirectionOpen, Elsewhere,    AgainstMap,
     PutBlindly,  PutUntilScan, WhereLeft, OdometryRestarted, Because,       InMap,        LaserInMap});

/// Returns @p how in the window's language; an unknown reason stays as it is.
[[nodiscard]] std::string inWindowsLanguage(const std::string& how);

}  // namespace leitstand::placement_format
