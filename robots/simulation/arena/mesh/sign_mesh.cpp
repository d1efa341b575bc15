#include "robots/simulation/arena/mesh/element_meshes.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"

namespace leitstand::simulation {

void addSign(MeshBuilder& builder, const ElementPlace& place) {
    const Element& sign = place.element;
    const Eigen::Vector3d half = sign.size / 2;
    const Look plain = builder.look();
    builder.box({-half.x(), -half.y(), 0.0}, {half.x(), half.y(), sign.size.z()});
    // The picture stands a hair in front of the plate.
    Look look = plain;
    look.surface.texture = builder.texture("sign " + sign.text, [&] { return signPicture(sign.text); });
    look.textureSize = 0.0;
    builder.setLook(look);
    constexpr double Hair = 0.001;
    const double y = -half.y() - Hair;
    builder.face({{-half.x(), y, 0.0},
                  {half.x(), y, 0.0},
                  {half.x(), y, sign.size.z()},
                  {-half.x(), y, sign.size.z()}});
    builder.setLook(plain);
}

}  // namespace leitstand::simulation
