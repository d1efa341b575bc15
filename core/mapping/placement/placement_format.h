#pragma once

#include <array>
#include <string>

#include "core/base/phrases/coded_text.h"
#include "core/base/words.h"

/// Phrases that say why a robot's pose in the map is certain or not, as they are in the log
/// (RobotPlaceSample::how). A value in a phrase is a figure, a name or another reason.
namespace leitstand::placement_format {

inline constexpr LogPhrase TooFewPoints = {
    "laser_sees_too_few",
    translatable("leitstand::Station", "its laser sees too little: {} points"),
    {"points"}};
inline constexpr LogPhrase TooLittle = {"laser_sees_too_little",
                                        translatable("leitstand::Station", "its laser sees too little")};
inline constexpr LogPhrase LittleInMap = {
    "too_little_in_map", translatable("leitstand::Station", "too little of what it sees is in the map")};
inline constexpr LogPhrase OnlyInMap = {
    "only_in_map",
    translatable("leitstand::Station", "only {} % of what it sees is in the map"),
    {"percent"}};
inline constexpr LogPhrase InMap = {
    "in_map", translatable("leitstand::Station", "{} % of what it sees is in the map"), {"percent"}};
inline constexpr LogPhrase LaserInMap = {
    "laser_in_map",
    translatable("leitstand::Station", "{} % of what its laser sees is in the map"),
    {"percent"}};
inline constexpr LogPhrase Because = {
    "because", translatable("leitstand::Station", "{}: {}"), {"doubt", "why"}};
inline constexpr LogPhrase FromGuess = {
    "in_map_from_guess",
    translatable("leitstand::Station",
                 "{} % of what it sees is in the map, {} cm and {} degrees from the guess"),
    {"percent", "away_cm", "turned_degrees"}};
inline constexpr LogPhrase DirectionOpen = {
    "direction_open", translatable("leitstand::Station", "the walls leave a direction open")};
inline constexpr LogPhrase Elsewhere = {
    "could_be_elsewhere", translatable("leitstand::Station", "it could as well stand elsewhere")};
inline constexpr LogPhrase FarFromTracks = {
    "far_from_tracks",
    translatable("leitstand::Station", "its laser fits {} cm from where its tracks say"),
    {"away_cm"}};
inline constexpr LogPhrase FoundAgain = {
    "found_again", translatable("leitstand::Station", "found again: {}"), {"how"}};
inline constexpr LogPhrase SeenBy = {
    "seen_by",
    translatable("leitstand::Station", "{} sees it: {} % of what its laser sees there is in the map"),
    {"robot", "percent"}};
inline constexpr LogPhrase AgainstMap = {
    "against_map", translatable("leitstand::Station", "it would see things where the map has none")};
inline constexpr LogPhrase PutBlindly = {
    "put_blindly", translatable("leitstand::Station", "put there by the operator; its laser says nothing")};
inline constexpr LogPhrase PutUntilScan = {
    "put_until_scan",
    translatable("leitstand::Station", "put there by the operator; its next scan tells where it stands")};
inline constexpr LogPhrase FoundByScan = {"found_in_whole_map",
                                          translatable("leitstand::Station",
                                                       "found in the whole map, where {} % of what it sees "
                                                       "fits; its next scan tells whether it stands there"),
                                          {"percent"}};
inline constexpr LogPhrase PutBut = {
    "put_but", translatable("leitstand::Station", "put there by the operator, but {}"), {"how"}};
inline constexpr LogPhrase WhereLeftBut = {
    "where_left_but",
    translatable("leitstand::Station", "where it was when the station was left: {}"),
    {"how"}};
inline constexpr LogPhrase WhereLeft = {
    "where_left", translatable("leitstand::Station", "where it was when the station was left")};
inline constexpr LogPhrase FitsMap = {"fits_map",
                                      translatable("leitstand::Station", "its scan fits the map")};
inline constexpr LogPhrase OwnPart = {
    "own_part",
    translatable("leitstand::Station", "it maps a part of its own, which has not met the rest yet")};
inline constexpr LogPhrase DoesNotFit = {"does_not_fit",
                                         translatable("leitstand::Station", "its scan does not fit")};
inline constexpr LogPhrase NewestKeyScan = {"newest_key_scan",
                                            translatable("leitstand::Station", "its newest key scan")};
inline constexpr LogPhrase OdometryRestarted = {
    "odometry_restarted", translatable("leitstand::Station", "its odometry began anew")};

/// All these phrases, beginning with the most specific.
inline constexpr auto All = std::to_array<LogPhrase>(
    {FoundByScan,   FoundAgain,   PutBut,    WhereLeftBut,      SeenBy,        TooFewPoints, FromGuess,
     TooLittle,     LittleInMap,  OnlyInMap, FarFromTracks,     DirectionOpen, Elsewhere,    AgainstMap,
     PutBlindly,    PutUntilScan, WhereLeft, OdometryRestarted, FitsMap,       OwnPart,      DoesNotFit,
     NewestKeyScan, Because,      InMap,     LaserInMap});

/// Returns whether @p how is @p phrase with any values.
[[nodiscard]] bool isPhrase(const std::string& how, const LogPhrase& phrase);
/// Returns @p how in the window's language. An unknown reason is not translated.
[[nodiscard]] std::string inWindowsLanguage(const std::string& how);

}  // namespace leitstand::placement_format
