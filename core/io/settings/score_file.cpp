#include "core/io/settings/score_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/settings/folders.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;

// JSON is YAML in flow style, so the reader of hostile YAML reads it, with line numbers.
constexpr std::string_view Keys[] = {
    "name",    "title",       "version",    "source",      "areas",      "points",          "hazard",
    "code",    "object",      "area_bump",  "victim_bump", "autonomous", "semi_autonomous", "operators",
    "minutes", "victim_tags", "unconfirmed"};
constexpr double MostPoints = 1e4, MostFactor = 100.0, MostMinutes = 1440.0;

void readAreas(const YamlFields& fields, ScoreProfile& profile, YamlErrors& errors) {
    if (!fields.has("areas")) return;
    const YamlFields areas(fields.at("areas"), errors);
    for (const auto& entry : areas.entries()) {
        double weight = 1.0;
        if (areas.number(entry.first, weight, 0.0, MostFactor, "")) profile.areas[entry.first] = weight;
    }
}

void readPoints(const YamlFields& fields, ScoreProfile& profile, YamlErrors& errors) {
    if (!fields.has("points")) return;
    std::array<std::string_view, ScoreItemCount> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = toString(static_cast<ScoreItem>(i));
    const YamlFields points(fields.at("points"), names, errors);
    for (std::size_t i = 0; i < names.size(); ++i) {
        double value = 0.0;
        if (points.has(names[i]) && points.number(names[i], value, 0.0, MostPoints, ""))
            profile.points[static_cast<ScoreItem>(i)] = value;
    }
}

void readUnconfirmed(const YamlFields& fields, ScoreProfile& profile) {
    for (const auto& place : fields.list("unconfirmed")) {
        const bool plain = place.value.IsScalar() && place.value.Scalar().size() <= 64;
        if (!plain) {
            fields.fail("unconfirmed", translate("leitstand::Error", "expected keys of this file"));
            return;
        }
        profile.unconfirmed.push_back(place.value.Scalar());
    }
}

void readTags(const YamlFields& fields, ScoreProfile& profile) {
    if (!fields.has("victim_tags")) return;
    profile.victimTags.clear();
    for (const auto& place : fields.list("victim_tags")) {
        const bool plain = place.value.IsScalar() && !place.value.Scalar().empty() &&
                           place.value.Scalar().size() <= 64 && profile.victimTags.size() < 32;
        if (!plain) {
            fields.fail("victim_tags",
                        translate("leitstand::Error", "expected at most 32 patterns such as \"V-#*\""));
            return;
        }
        profile.victimTags.push_back(place.value.Scalar());
    }
}

void readAll(const YamlFields& fields, ScoreProfile& profile, YamlErrors& errors) {
    for (const std::string_view key : {"name", "version", "points"}) {
        if (!fields.has(key)) fields.fail(key, translate("leitstand::Error", "is missing"));
    }
    fields.text("name", profile.name);
    profile.title = profile.name;
    fields.text("title", profile.title);
    fields.text("version", profile.version);
    fields.text("source", profile.source, /*maybeEmpty=*/true);
    readAreas(fields, profile, errors);
    readPoints(fields, profile, errors);
    fields.number("hazard", profile.hazard, 0.0, MostPoints, "");
    fields.number("code", profile.code, 0.0, MostPoints, "");
    fields.number("object", profile.object, 0.0, MostPoints, "");
    fields.number("area_bump", profile.areaBump, 0.0, MostPoints, "");
    fields.number("victim_bump", profile.victimBump, 0.0, MostPoints, "");
    fields.number("autonomous", profile.autonomous, 1.0, MostFactor, "");
    fields.number("semi_autonomous", profile.semiAutonomous, 1.0, MostFactor, "");
    fields.choice<OperatorRule>("operators", profile.operators,
                                {{"none", OperatorRule::None},
                                 {"count", OperatorRule::Count},
                                 {"squared_of_more", OperatorRule::SquaredOfMore}});
    fields.number("minutes", profile.minutes, 0.0, MostMinutes, " min");
    readTags(fields, profile);
    readUnconfirmed(fields, profile);
}

}  // namespace

Result<ScoreProfile> parseScoreProfile(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors(name);
    ScoreProfile profile;
    try {
        readAll(YamlFields({*root, {}, 1}, Keys, errors), profile, errors);
        if (errors.empty()) return profile;
    } catch (const YAML::Exception& problem) {
        errors.add(std::max(0, problem.mark.line) + 1, {},
                   leitstand::fill(translate("leitstand::Error", "expected JSON, found a mistake: {}"),
                                   problem.msg));
    }
    return errors.error();
}

Result<ScoreProfile> readScoreProfile(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::error_code ignored;
    if (!in || std::filesystem::is_directory(file, ignored))
        return Error{
            leitstand::fill(translate("leitstand::Error",
                                      "{}: expected the rules of a score, found no file that can be read"),
                            file.string())};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseScoreProfile(text, file.string());
}

const ScoreProfile* ScoreProfiles::find(const std::string& name) const {
    const auto found = std::find_if(profiles.begin(), profiles.end(),
                                    [&](const ScoreProfile& profile) { return profile.name == name; });
    if (found != profiles.end()) return &*found;
    return profiles.empty() ? nullptr : &profiles.back();
}

ScoreProfiles scoreProfiles() {
    return scoreProfilesIn({shippedFolder("scoring"), userFolder("scoring")});
}

ScoreProfiles scoreProfilesIn(const std::vector<std::filesystem::path>& folders) {
    ScoreProfiles all;
    std::map<std::string, ScoreProfile> byName;
    for (const auto& folder : folders) {
        std::error_code none;
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
            if (entry.path().extension() == ".json") files.push_back(entry.path());
        }
        std::sort(files.begin(), files.end());
        for (const auto& file : files) {
            auto profile = readScoreProfile(file);
            if (profile) {
                byName[profile->name] = *profile;
            } else {
                all.problems.push_back(profile.error().text);
            }
        }
    }
    for (auto& [name, profile] : byName) all.profiles.push_back(std::move(profile));
    return all;
}

}  // namespace leitstand
