#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leitstand {

struct RobotDescription;

/// How far a number is from what it should be.
enum class ReadingLevel : std::uint8_t { Normal, Attention, Act };

/// Where a number should stay, in ReadingDescription::unit. What is empty is no limit.
struct ReadingLimits {
    std::optional<double> low, high;        ///< beyond these the operator should look
    std::optional<double> lowAct, highAct;  ///< beyond these the operator must act

    [[nodiscard]] bool any() const { return low || high || lowAct || highAct; }
    friend bool operator==(const ReadingLimits&, const ReadingLimits&) = default;
};

/// Returns the level of @p value; Normal if it is unknown. @p standing: the level until now. A level ends
/// only when the number is inside by 2 % of the limit, or less where the limits are close together. So a
/// number at its limit does not alarm over and over.
[[nodiscard]] ReadingLevel levelOf(const ReadingLimits& limits, double value,
                                   ReadingLevel standing = ReadingLevel::Normal);

/// A number in the messages of a topic that the operator sees: value = scale * field + offset.
struct ReadingDescription {
    static constexpr std::size_t MostOfATopic = 16;

    /// Path in the message: "temperature", "cell_voltage[2]", "status.level". Of a vector with x, y and z:
    /// its length.
    std::string field;
    std::string title;  ///< for operators, another one for each reading of a robot
    std::string unit;   ///< "°C"; may be empty
    double scale = 1.0, offset = 0.0;
    std::optional<int> decimals = {};  ///< digits after the point; empty: as many as are read at a glance
    ReadingLimits limits = {};
    friend bool operator==(const ReadingDescription&, const ReadingDescription&) = default;
};

inline constexpr const char* ReadingTitles = "leitstand::Readings";  ///< context of translations

/// Returns the numbers that are shown of messages of the ROS type @p type, if a robot's file names none;
/// empty: the file must name them. Their titles are in English (ReadingTitles).
[[nodiscard]] std::vector<ReadingDescription> usualReadings(std::string_view type);

/// Appends the topic to titles that several readings of @p robot have.
void distinguishReadings(RobotDescription& robot);

}  // namespace leitstand
