#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/mission/finds/victim_tags.h"

namespace leitstand {

/// An item on which the report of a victim is scored.
enum class ScoreItem : std::uint8_t {
    Map,       ///< quality of the map around the victim; only judges rate it, so full points are assumed
    Location,  ///< the victim's place in the map
    Form,      ///< form of the victim is reported
    Motion,    ///< whether it moves is reported; heat, sound and CO2 work the same way
    Heat,
    Sound,
    Co2,
    Situation,  ///< whether it is on the surface, trapped, in a void or entombed
    Tag,        ///< text of its tag
};
inline constexpr std::size_t ScoreItemCount = 9;
/// Key of an item in a profile: "map", "location", "form", ...
[[nodiscard]] const char* toString(ScoreItem item);

/// How the sum is divided by the number of operators.
enum class OperatorRule : std::uint8_t {
    None,
    Count,          ///< divided by the number of operators
    SquaredOfMore,  ///< divided by (1 + operators) squared
};

/// The rules of one year, from a file (resources/scoring): how many points each thing is worth.
struct ScoreProfile {
    std::string name;                     ///< "2005"
    std::string title;                    ///< "RoboCup Rescue Robot League 2005"
    std::string version;                  ///< version of the file
    std::string source;                   ///< source of its values
    std::map<std::string, double> areas;  ///< weights of areas by name; other areas have weight 1
    /// Points for items of a victim; items that are missing give no points.
    std::map<ScoreItem, double> points;
    double hazard = 0.0, code = 0.0, object = 0.0;  ///< points for a confirmed find of each kind
    double areaBump = 0.0, victimBump = 0.0;        ///< points that one bump costs
    double autonomous = 1.0, semiAutonomous = 1.0;  ///< factors on finds that a robot made by itself
    OperatorRule operators = OperatorRule::None;
    TagPatterns victimTags = usualTags();  ///< which codes are tags of victims; empty: none
    double minutes = 0.0;                  ///< length of a mission [min]; 0: unknown
    std::vector<std::string> unconfirmed;  ///< keys of values for which no readable source was found
};

}  // namespace leitstand
