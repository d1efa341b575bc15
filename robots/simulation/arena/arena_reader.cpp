#include <array>
#include <set>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"
#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/element_reader.h"

namespace leitstand::simulation {
namespace {

using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;

constexpr std::size_t MostElements = 2'000;
constexpr std::size_t MostStarts = 20;

constexpr std::array<std::string_view, 9> ArenaKeys = {"name",    "grade", "seed",   "from",    "to",
                                                       "ambient", "light", "starts", "elements"};
constexpr std::array<std::string_view, 2> StartKeys = {"position", "turn"};

void readCorner(const YamlFields& fields, const char* key, Eigen::Vector2d& corner) {
    std::vector<double> found;
    if (!fields.has(key)) {
        fields.fail(key, "expected 2 numbers [m], found nothing");
    } else if (fields.numbers(key, found, 2, FarthestPlace, " m")) {
        corner = {found[0], found[1]};
    }
}

void readGround(const YamlFields& fields, Arena& arena) {
    readCorner(fields, "from", arena.from);
    readCorner(fields, "to", arena.to);
    const Eigen::Vector2d extent = arena.to - arena.from;
    if (fields.has("from") && fields.has("to") && !(extent.minCoeff() > 0.0)) {
        fields.fail("to", "expected a corner beyond \"from\" in x and y");
    }
    if (extent.maxCoeff() > LargestGround) {
        fields.fail("to", fmt::format("expected at most {} m from \"from\"", LargestGround));
    }
}

void readStarts(const YamlFields& fields, Arena& arena, YamlErrors& errors) {
    if (!fields.has("starts")) return;
    const YamlFields starts(fields.at("starts"), errors);
    if (starts.entries().size() > MostStarts) {
        fields.fail("starts",
                    fmt::format("expected at most {} robots, found {}", MostStarts, starts.entries().size()));
        return;
    }
    for (const auto& [robot, place] : starts.entries()) {
        arena.starts[robot] = readPose(YamlFields(place, StartKeys, errors));
    }
}

void readElements(const YamlFields& fields, Arena& arena, YamlErrors& errors) {
    std::set<std::string> names;
    const auto places = fields.list("elements");
    if (places.size() > MostElements) {
        fields.fail("elements",
                    fmt::format("expected at most {} elements, found {}", MostElements, places.size()));
        return;
    }
    for (const YamlPlace& place : places) {
        Element element = readElement(place, arena.ambient, errors);
        if (element.name.empty()) {
            element.name = fmt::format("{} at {}", toString(element.kind), arena.elements.size());
        }
        if (!names.insert(element.name).second) {
            errors.add(place.line, place.path + ".name",
                       "expected a name of its own, found " + detail::shown(element.name) + " again");
        }
        arena.elements.push_back(std::move(element));
    }
}

}  // namespace

Result<Arena> parseArena(std::string_view text, const std::string& name) {
    const auto document = detail::loadYaml(text, name);
    if (!document) return document.error();
    YamlErrors errors(name);
    Arena arena;
    try {
        const YamlFields fields({*document, "", 1}, ArenaKeys, errors);
        fields.text("name", arena.name, true);
        std::vector<std::pair<std::string, Grade>> grades;
        grades.reserve(GradeCount);
        for (int i = 0; i < GradeCount; ++i) {
            grades.emplace_back(toString(static_cast<Grade>(i)), static_cast<Grade>(i));
        }
        fields.choice("grade", arena.grade, grades);
        readSeed(fields, "seed", arena.seed);
        readGround(fields, arena);
        fields.number("ambient", arena.ambient, ColdestThing, HottestThing, " degrees C");
        fields.number("light", arena.light, 0.0, 1.0, "");
        readStarts(fields, arena, errors);
        readElements(fields, arena, errors);
    } catch (const YAML::Exception& problem) {  // an error that the checks did not foresee
        return Error{fmt::format("{}:{}: {}", name, problem.mark.line + 1, problem.msg)};
    }
    if (!errors.empty()) return errors.error();
    return arena;
}

}  // namespace leitstand::simulation
