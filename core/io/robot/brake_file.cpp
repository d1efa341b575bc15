#include "core/io/robot/brake_file.h"

#include <array>
#include <chrono>
#include <cmath>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"
#include "core/io/yaml/yaml_document.h"

namespace leitstand {
namespace {

using Verdict = BrakeResult::Verdict;

constexpr auto Stops = BrakeResult::Watchdog::Stops, None = BrakeResult::Watchdog::None;

/// Words for verdicts; untested robots are not stored.
constexpr std::array<std::pair<const char*, Verdict>, 2> Words = {
    {{"passed", Verdict::Passed}, {"failed", Verdict::Failed}}};

bool isLength(double value) {
    return std::isfinite(value) && value >= 0.0;
}

}  // namespace

std::map<std::string, BrakeResult> readBrakes(const std::filesystem::path& file) {
    std::map<std::string, BrakeResult> results;
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    const auto root = detail::loadYaml(text.str(), file.string());
    if (!root || !root->IsMap()) return results;
    const YAML::Node brakes = (*root)["brakes"];
    if (!brakes || !brakes.IsMap()) return results;
    for (const auto& entry : brakes) {
        BrakeResult result;
        try {
            for (const auto& [word, verdict] : Words) {
                if (entry.second["verdict"].as<std::string>() == word) result.verdict = verdict;
            }
            if (result.verdict == Verdict::Untested) continue;
            if (result.verdict == Verdict::Failed)  // even with invalid figures
                results[entry.first.as<std::string>()].verdict = result.verdict;
            result.seconds = entry.second["seconds"].as<double>();
            result.metres = entry.second["metres"].as<double>();
            const auto when = entry.second["when"].as<std::uint32_t>();  // [s], up to 2106
            result.when = Time(std::chrono::seconds(when));
            if (const auto stops = entry.second["stops"]) {
                result.watchdog = stops.as<bool>() ? Stops : None;
                if (result.watchdog == Stops) result.brakesAfter = entry.second["brakes_after"].as<double>();
            }
            if (isLength(result.seconds) && isLength(result.metres) && std::isfinite(result.brakesAfter))
                results[entry.first.as<std::string>()] = result;
        } catch (const YAML::Exception&) {
            continue;  // an invalid entry does not release other robots that failed
        }
    }
    return results;
}

Result<void> writeBrakes(const std::filesystem::path& file,
                         const std::map<std::string, BrakeResult>& results) {
    YAML::Emitter out;
    out << YAML::Comment("Brake tests of robots that this station drives.") << YAML::BeginMap;
    out << YAML::Key << "brakes" << YAML::Value << YAML::BeginMap;
    for (const auto& [robot, result] : results) {
        for (const auto& [word, verdict] : Words) {
            if (result.verdict != verdict) continue;
            out << YAML::Key << robot << YAML::Value << YAML::BeginMap << YAML::Key << "verdict"
                << YAML::Value << word << YAML::Key << "seconds" << YAML::Value
                << fmt::format("{:.3f}", result.seconds) << YAML::Key << "metres" << YAML::Value
                << fmt::format("{:.3f}", result.metres) << YAML::Key << "when" << YAML::Value
                << std::chrono::floor<std::chrono::seconds>(result.when.time_since_epoch()).count();
            if (result.watchdog != BrakeResult::Watchdog::Unknown)
                out << YAML::Key << "stops" << YAML::Value << (result.watchdog == Stops);
            if (result.watchdog == Stops)
                out << YAML::Key << "brakes_after" << YAML::Value
                    << fmt::format("{:.3f}", result.brakesAfter);
            out << YAML::EndMap;
        }
    }
    out << YAML::EndMap << YAML::EndMap << YAML::Newline;
    return detail::writeWhole(file, out.c_str());
}

}  // namespace leitstand
