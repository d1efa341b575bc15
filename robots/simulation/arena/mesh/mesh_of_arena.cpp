#include "robots/simulation/arena/mesh/element_meshes.h"

namespace leitstand::simulation {
namespace {

void addElement(MeshBuilder& builder, const ElementPlace& place, std::vector<MovingPart>& moving) {
    const Element& element = place.element;
    switch (element.kind) {
        case ElementKind::Floor:
            return addFloor(builder, element);
        case ElementKind::Wall:
        case ElementKind::Ceiling:
        case ElementKind::Overhang:
            return addWall(builder, element);
        case ElementKind::Door:
            return addDoor(builder, element);
        case ElementKind::Ramp:
            return addRamp(builder, element);
        case ElementKind::Stairs:
            return addStairs(builder, element);
        case ElementKind::StepField:
            return addStepField(builder, element);
        case ElementKind::Lamp:
            return addLamp(builder, element);
        case ElementKind::Heater:
            return addHeater(builder, element);
        case ElementKind::Table:
            return addTable(builder, element);
        case ElementKind::Chair:
            return addChair(builder, element);
        case ElementKind::Curtain:
            return addCurtain(builder, element);
        case ElementKind::LoosePaper:
            return addLoosePaper(builder, element);
        case ElementKind::Foil:
            return addFoil(builder, element);
        case ElementKind::Rubble:
            return addRubble(builder, place);
        case ElementKind::Victim:
            return addVictim(builder, place, moving);
        case ElementKind::Sign:
            return addSign(builder, place);
        case ElementKind::Spectator:
            return addSpectator(place, moving);
        case ElementKind::Smoke:
            return;  // no surface: Scene limits how far lasers see in it
    }
}

}  // namespace

ArenaMesh meshOf(const Arena& arena) {
    ArenaMesh mesh;
    MeshBuilder builder(mesh.still);
    for (std::size_t i = 0; i < arena.elements.size(); ++i) {
        const ElementPlace place{arena, arena.elements[i], static_cast<int>(i)};
        builder.setFrame(place.element.pose);
        builder.setLook(lookOf(place, builder));
        addElement(builder, place, mesh.moving);
    }
    return mesh;
}

}  // namespace leitstand::simulation
