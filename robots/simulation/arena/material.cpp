#include "robots/simulation/arena/material.h"

#include <array>
#include <string_view>

namespace leitstand::simulation {
namespace {

struct Entry {
    std::string_view name;
    MaterialProperties properties;
};

const std::array<Entry, MaterialCount> Entries = {{
    {"concrete", {{0.46F, 0.45F, 0.43F}, 0.45F, 0.94F, 0.0F, true}},
    {"plywood", {{0.66F, 0.50F, 0.33F}, 0.60F, 0.90F, 0.0F, true}},
    {"plaster", {{0.80F, 0.79F, 0.75F}, 0.75F, 0.92F, 0.0F, true}},
    {"metal", {{0.56F, 0.57F, 0.58F}, 0.55F, 0.30F, 0.0F, true}},
    {"black", {{0.03F, 0.03F, 0.03F}, 0.01F, 0.95F, 0.0F, true}},
    {"cloth", {{0.25F, 0.32F, 0.50F}, 0.50F, 0.90F, 0.0F, false}},
    {"paper", {{0.85F, 0.84F, 0.80F}, 0.80F, 0.92F, 0.0F, false}},
    {"foil", {{0.75F, 0.77F, 0.80F}, 0.40F, 0.20F, 0.85F, false}},
    {"skin", {{0.76F, 0.57F, 0.45F}, 0.60F, 0.98F, 0.0F, true}},
    {"glass", {{0.95F, 0.93F, 0.85F}, 0.20F, 0.90F, 0.0F, true}},
    {"rubber", {{0.08F, 0.08F, 0.08F}, 0.10F, 0.95F, 0.0F, true}},
    {"pane", {{0.55F, 0.62F, 0.64F}, 0.03F, 0.90F, 0.0F, true}},
}};

}  // namespace

const MaterialProperties& propertiesOf(Material material) {
    return Entries[static_cast<std::size_t>(material)].properties;
}

std::string toString(Material material) {
    return std::string(Entries[static_cast<std::size_t>(material)].name);
}

}  // namespace leitstand::simulation
