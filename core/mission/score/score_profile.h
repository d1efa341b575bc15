#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/mission/finds/victim_tags.h"

namespace leitstand {

/// An item by which a victim's report is judged.
enum class ScoreItem : std::uint8_t {
    Map,       ///< quality of the map around the victim; only judges rate it, so full points are assumed
    Location,  ///< it has a place in the map
    Form,      ///< its form is reported
    Motion,    ///< motion or its absence is reported; heat, sound and CO2 work the same way
    Heat,
    Sound,
    Co2,
    Situation,  ///< surface, trapped, void or entombed
    Tag,        ///< its text
};
inline constexpr std::size_t ScoreItemCount = 9;
/// Key of an item in a profile: "map", "location", "form", ...
[[nodiscard]] const char* toString(ScoreItem item);

/// How the sum is divided by the number of operators.
enum class OperatorRule : std::uint8_t {
    None,
    Count,          ///< by the operators
    SquaredOfMore,  ///< by (1 + operators) squared
};

/// The rules of a year, from a file (resources/scoring): how much each thing is worth.
struct ScoreProfile {
    std::string name;                               ///< "2005"
    std::string title;                              ///< "RoboCup Rescue Robot League 2005"
    std::string version;                            ///< of the file
    std::string source;                             ///< source of its values
    std::map<std::string, double> areas;            ///< weight by name; others weigh 1
    std::map<ScoreItem, double> points;             ///< of a victim; items that are missing are worth nothing
    double hazard = 0.0, code = 0.0, object = 0.0;  ///< of a confirmed one
    double areaBump = 0.0, victimBump = 0.0;        ///< what each costs
    double autonomous = 1.0, semiAutonomous = 1.0;  ///< factors on what a robot found by itself
    OperatorRule operators = OperatorRule::None;
    TagPatterns victimTags = usualTags();  ///< codes that are tags of victims; empty: no code is a tag
    double minutes = 0.0;                  ///< length of a mission [min]; 0: unknown
    std::vector<std::string> unconfirmed;  ///< keys of values for which no readable source was found
};

}  // namespace leitstand
