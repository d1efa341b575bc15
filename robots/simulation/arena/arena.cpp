#include "robots/simulation/arena/arena.h"

#include <array>
#include <string_view>

namespace leitstand::simulation {
namespace {

constexpr std::array<std::string_view, GradeCount> Grades = {"yellow", "orange", "red", "building"};
constexpr std::array<std::string_view, SituationCount> Situations = {"surface", "trapped", "void",
                                                                     "entombed"};

struct KindEntry {
    std::string_view name;
    Eigen::Vector3d size;
    Material material;
};
const std::array<KindEntry, ElementKindCount> Kinds = {{
    {"floor", {8.0, 8.0, 0.1}, Material::Concrete},   {"wall", {1.2, 0.05, 1.2}, Material::Plywood},
    {"door", {1.2, 0.05, 1.2}, Material::Plywood},    {"ramp", {1.2, 1.2, 0.2}, Material::Plywood},
    {"stairs", {1.2, 1.2, 0.4}, Material::Plywood},   {"step_field", {1.2, 1.2, 0.3}, Material::Plywood},
    {"ceiling", {1.2, 1.2, 0.03}, Material::Plaster}, {"lamp", {0.12, 0.12, 0.12}, Material::Glass},
    {"heater", {0.6, 0.1, 0.5}, Material::Metal},     {"table", {1.0, 0.6, 0.6}, Material::Plywood},
    {"chair", {0.42, 0.42, 0.85}, Material::Plywood}, {"overhang", {0.6, 0.3, 0.03}, Material::Plywood},
    {"curtain", {1.0, 0.06, 1.1}, Material::Cloth},   {"loose_paper", {0.4, 0.3, 0.12}, Material::Paper},
    {"foil", {0.8, 0.04, 0.8}, Material::Foil},       {"rubble", {1.2, 1.2, 0.2}, Material::Concrete},
    {"victim", {1.3, 0.42, 0.26}, Material::Cloth},   {"sign", {0.3, 0.01, 0.3}, Material::Plaster},
    {"spectator", {0.3, 0.5, 1.75}, Material::Cloth}, {"smoke", {4.0, 2.0, 2.2}, Material::Cloth},
}};

}  // namespace

std::string toString(Grade grade) {
    return std::string(Grades[static_cast<std::size_t>(grade)]);
}

std::string toString(Situation situation) {
    return std::string(Situations[static_cast<std::size_t>(situation)]);
}

std::string toString(ElementKind kind) {
    return std::string(Kinds[static_cast<std::size_t>(kind)].name);
}

bool warmByItself(ElementKind kind) {
    return kind == ElementKind::Lamp || kind == ElementKind::Heater || kind == ElementKind::Spectator;
}

Element elementOf(ElementKind kind) {
    Element element;
    element.kind = kind;
    element.size = Kinds[static_cast<std::size_t>(kind)].size;
    element.material = Kinds[static_cast<std::size_t>(kind)].material;
    switch (kind) {
        case ElementKind::Door:
            element.width = 0.9;
            break;
        case ElementKind::Stairs:
            element.riser = 0.1;
            break;
        case ElementKind::StepField:
            element.cell = 0.1;
            break;
        case ElementKind::Lamp:
            element.temperature = 60.0;
            break;
        case ElementKind::Heater:
            element.temperature = 45.0;
            break;
        case ElementKind::Spectator:
            element.temperature = 33.0;
            break;
        case ElementKind::Smoke:
            element.reach = 2.0;
            break;
        case ElementKind::Victim:
            element.victim.emplace();
            break;
        case ElementKind::Floor:
        case ElementKind::Wall:
        case ElementKind::Ramp:
        case ElementKind::Ceiling:
        case ElementKind::Table:
        case ElementKind::Chair:
        case ElementKind::Overhang:
        case ElementKind::Curtain:
        case ElementKind::LoosePaper:
        case ElementKind::Foil:
        case ElementKind::Rubble:
        case ElementKind::Sign:
            break;
    }
    return element;
}

}  // namespace leitstand::simulation
