#pragma once

#include <vector>

#include "robots/simulation/arena/arena.h"
#include "robots/simulation/arena/mesh/mesh_builder.h"

namespace leitstand::simulation {

/// An element and its arena.
struct ElementPlace {
    const Arena& arena;
    const Element& element;
    int index = 0;  ///< index of the element in the arena
};

/// Returns the look of an element's main part: colour and texture of its material, its temperature.
[[nodiscard]] Look lookOf(const ElementPlace& place, MeshBuilder& builder);
/// Returns the look of another part of an element, which has @p material and the arena's temperature.
[[nodiscard]] Look lookOf(const ElementPlace& place, Material material, MeshBuilder& builder);

// Each adds its shapes in the builder's frame, which is the element's, and with the builder's look.
void addFloor(MeshBuilder& builder, const Element& element);
void addWall(MeshBuilder& builder, const Element& element);
void addDoor(MeshBuilder& builder, const Element& element);
void addRamp(MeshBuilder& builder, const Element& element);
void addStairs(MeshBuilder& builder, const Element& element);
void addStepField(MeshBuilder& builder, const Element& element);
void addHeater(MeshBuilder& builder, const Element& element);
void addTable(MeshBuilder& builder, const Element& element);
void addChair(MeshBuilder& builder, const Element& element);
void addLamp(MeshBuilder& builder, const Element& element);
void addCurtain(MeshBuilder& builder, const Element& element);
void addLoosePaper(MeshBuilder& builder, const Element& element);
void addFoil(MeshBuilder& builder, const Element& element);
void addRubble(MeshBuilder& builder, const ElementPlace& place);
void addSign(MeshBuilder& builder, const ElementPlace& place);

/// Adds a manikin and what hides it. A waving arm is added to @p moving.
void addVictim(MeshBuilder& builder, const ElementPlace& place, std::vector<MovingPart>& moving);
/// Adds a person to @p moving.
void addSpectator(const ElementPlace& place, std::vector<MovingPart>& moving);

}  // namespace leitstand::simulation
