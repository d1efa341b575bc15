#include "robots/simulation/arena/mesh/element_meshes.h"
#include "robots/simulation/arena/mesh/textures.h"
#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {
namespace {

constexpr double AbsoluteZero = -273.15;  ///< [degrees C]

bool isStructure(ElementKind kind) {
    switch (kind) {
        case ElementKind::Floor:
        case ElementKind::Wall:
        case ElementKind::Door:
        case ElementKind::Ramp:
        case ElementKind::Stairs:
        case ElementKind::StepField:
        case ElementKind::Ceiling:
            return true;
        case ElementKind::Lamp:
        case ElementKind::Heater:
        case ElementKind::Table:
        case ElementKind::Chair:
        case ElementKind::Overhang:
        case ElementKind::Curtain:
        case ElementKind::LoosePaper:
        case ElementKind::Foil:
        case ElementKind::Rubble:
        case ElementKind::Victim:
        case ElementKind::Sign:
        case ElementKind::Spectator:
        case ElementKind::Smoke:
            break;
    }
    return false;
}

int textureOf(Material material, ElementKind kind, MeshBuilder& builder) {
    switch (material) {
        case Material::Plywood:
            return builder.texture("plywood", plywoodTexture);
        case Material::Concrete:
            return builder.texture("concrete", concreteTexture);
        case Material::Plaster:
            return builder.texture("plaster", plasterTexture);
        case Material::Paper:
            return kind == ElementKind::LoosePaper ? builder.texture("newspaper", newspaperTexture) : -1;
        case Material::Cloth:
            return kind == ElementKind::Curtain ? builder.texture("cloth", clothTexture) : -1;
        case Material::Metal:
        case Material::Black:
        case Material::Foil:
        case Material::Skin:
        case Material::Glass:
        case Material::Rubber:
        case Material::Pane:
            break;
    }
    return -1;
}

}  // namespace

Look lookOf(const ElementPlace& place, Material material, MeshBuilder& builder) {
    Look look;
    look.surface.material = material;
    look.surface.colour = propertiesOf(material).albedo;
    look.surface.temperature = static_cast<float>(place.arena.ambient - AbsoluteZero);
    look.surface.element = place.index;
    look.surface.texture = textureOf(material, place.element.kind, builder);
    Random random(static_cast<std::uint64_t>(place.index));
    look.textureShift = random.uniform();
    if (material == Material::Plywood || material == Material::Concrete || material == Material::Plaster) {
        look.textureSize = MaterialTextureSize;
    }
    return look;
}

Look lookOf(const ElementPlace& place, MeshBuilder& builder) {
    Look look = lookOf(place, place.element.material, builder);
    look.structural = isStructure(place.element.kind);
    look.surface.temperature = static_cast<float>(place.element.temperature - AbsoluteZero);
    if (place.element.kind == ElementKind::Lamp) look.surface.glow = 3.0F;
    return look;
}

}  // namespace leitstand::simulation
