#include <set>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/io/robot/yaml_document.h"
#include "core/io/robot/yaml_fields.h"
#include "robots/simulation/arena/arena_file.h"
#include "robots/simulation/arena/element_reader.h"

namespace leitstand::simulation {
namespace {

using detail::YamlErrors;
using detail::YamlFields;

constexpr std::size_t MostElements = 2'000;
constexpr std::size_t MostStarts = 20;

void readCorner(const YamlFields& fields, const char* key, Eigen::Vector2d& corner) {
    if (!fields.has(key)) return fields.fail(key, "expected two numbers [m], found nothing");
    const std::vector<double> found = fields.numbers(key, 2, FarthestPlace);
    if (!found.empty()) corner = {found[0], found[1]};
}

void readStarts(const YamlFields& fields, Arena& arena, YamlErrors& errors) {
    fields.each("starts", true,
                [&](const YAML::Node& node, const std::string& robot, const std::string& path) {
                    const YamlFields start(node, path, {"position", "turn"}, errors);
                    if (arena.starts.size() == MostStarts) {
                        return start.fail("position", fmt::format("expected at most {} starts", MostStarts));
                    }
                    arena.starts[robot] = readPose(start);
                });
}

void readElements(const YamlFields& fields, Arena& arena, YamlErrors& errors) {
    std::set<std::string> names;
    fields.each("elements", false, [&](const YAML::Node& node, const std::string&, const std::string& path) {
        if (arena.elements.size() > MostElements) return;
        if (arena.elements.size() == MostElements) {
            errors.add(node, path, fmt::format("expected at most {} elements", MostElements));
        }
        Element element = readElement(node, path, arena.ambient, errors);
        if (element.name.empty()) {
            element.name = fmt::format("{} at {}", toString(element.kind), arena.elements.size());
        }
        if (!names.insert(element.name).second) {
            errors.add(node, path + ".name",
                       fmt::format("expected a name of its own, found \"{}\" again", element.name));
        }
        arena.elements.push_back(std::move(element));
    });
}

}  // namespace

Result<Arena> parseArena(std::string_view text, const std::string& name) {
    const auto document = detail::loadYaml(text, name);
    if (!document) return document.error();
    YamlErrors errors{name, {}};
    Arena arena;
    try {
        const YamlFields fields(
            *document, "", {"name", "grade", "seed", "from", "to", "ambient", "light", "starts", "elements"},
            errors);
        fields.text("name", arena.name);
        std::vector<std::pair<std::string, Grade>> grades;
        for (int i = 0; i < GradeCount; ++i)
            grades.emplace_back(toString(static_cast<Grade>(i)), static_cast<Grade>(i));
        fields.choice("grade", arena.grade, grades);
        readSeed(fields, "seed", arena.seed);
        readCorner(fields, "from", arena.from);
        readCorner(fields, "to", arena.to);
        if (fields.has("from") && fields.has("to") && !((arena.to - arena.from).minCoeff() > 0.0)) {
            fields.fail("to", "expected a corner beyond \"from\" in x and y");
        }
        if ((arena.to - arena.from).maxCoeff() > LargestGround) {
            fields.fail("to", fmt::format("expected at most {} m from \"from\"", LargestGround));
        }
        fields.number("ambient", arena.ambient, ColdestThing, HottestThing);
        fields.number("light", arena.light, 0.0, 1.0);
        readStarts(fields, arena, errors);
        readElements(fields, arena, errors);
    } catch (const YAML::Exception& problem) {  // of what the checks did not foresee
        return Error{fmt::format("{}:{}: {}", name, problem.mark.line + 1, problem.msg)};
    }
    if (!errors.texts.empty()) return Error{fmt::format("{}", fmt::join(errors.texts, "\n"))};
    return arena;
}

}  // namespace leitstand::simulation
