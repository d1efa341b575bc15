#include "robots/simulation/arena/mesh/textures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "robots/simulation/arena/random.h"

namespace leitstand::simulation {
namespace {

constexpr int Edge = 384;  ///< [px]

/// Returns a pseudo-random value from 0 to 1 for a place on a grid.
double hashAt(int x, int y, int layer) {
    const auto key = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32U) ^
                     static_cast<std::uint32_t>(y) ^ (static_cast<std::uint64_t>(layer) << 60U);
    return Random(key).uniform();
}

/// Returns smooth noise from 0 to 1.
double noise(double x, double y, int layer) {
    const double left = std::floor(x);
    const double low = std::floor(y);
    const auto eased = [](double t) { return t * t * (3.0 - 2.0 * t); };
    const double u = eased(x - left);
    const double v = eased(y - low);
    const int i = static_cast<int>(left);
    const int j = static_cast<int>(low);
    return (1 - v) * ((1 - u) * hashAt(i, j, layer) + u * hashAt(i + 1, j, layer)) +
           v * ((1 - u) * hashAt(i, j + 1, layer) + u * hashAt(i + 1, j + 1, layer));
}

/// Returns noise of four octaves, from 0 to 1.
double cloudy(double x, double y, int layer) {
    double sum = 0.0;
    double weight = 0.5;
    for (int octave = 0; octave < 4; ++octave) {
        sum += weight * noise(x, y, layer + octave);
        x *= 2.1;
        y *= 2.1;
        weight /= 2.0;
    }
    return sum / 0.9375;
}

/// Paints a texture with @p colour at u and v, both from 0 to 1, v upwards.
Texture painted(int width, int height, const std::function<Eigen::Vector3d(double u, double v)>& colour) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    texture.pixels.reserve(static_cast<std::size_t>(3 * width * height));
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Eigen::Vector3d one = colour((column + 0.5) / width, 1.0 - (row + 0.5) / height);
            for (int i = 0; i < 3; ++i) {
                texture.pixels.push_back(
                    static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(one[i], 0.0, 1.0))));
            }
        }
    }
    return texture;
}

/// Returns the distance of (u, v) from a crack that wanders.
double crack(double u, double v, double start, int layer) {
    return std::abs(v - start - 0.3 * (cloudy(3.0 * u, start * 17.0, layer) - 0.5) -
                    0.05 * noise(40.0 * u, 0, layer));
}

Texture makePlywood() {
    struct Knot {
        double u, v, size;
    };
    std::vector<Knot> knots;
    Random random(11);
    for (int i = 0; i < 9; ++i)
        knots.push_back({random.uniform(), random.uniform(), random.between(0.006, 0.014)});
    return painted(Edge, Edge, [knots](double u, double v) -> Eigen::Vector3d {
        double bent = v;
        double dark = 0.0;
        for (const Knot& knot : knots) {
            const double du = (u - knot.u) / 3.0;
            const double dv = v - knot.v;
            const double near = std::exp(-(du * du + dv * dv) / (4.0 * knot.size * knot.size));
            bent += 1.5 * dv * near;
            dark += std::exp(-(9 * du * du + dv * dv) / (knot.size * knot.size));
        }
        const int sheet = static_cast<int>(std::floor(v * 6.0));  // strips of veneer, each of its own tone
        const double tone = 0.10 * (hashAt(sheet, 0, 3) - 0.5);
        const double rings = noise(2.0 * u, 60.0 * bent + 4.0 * cloudy(2.0 * u, 3.0 * v, 5), 1);
        const double grain = noise(9.0 * u, 190.0 * v, 2);
        const double bright =
            1.0 + tone + 0.24 * (rings - 0.5) + 0.14 * (grain - 0.5) - 0.55 * std::min(1.0, dark);
        return bright * Eigen::Vector3d(0.76, 0.60, 0.41);
    });
}

Texture makeConcrete() {
    return painted(Edge, Edge, [](double u, double v) -> Eigen::Vector3d {
        double bright =
            0.55 + 0.26 * (cloudy(7 * u, 7 * v, 1) - 0.5) + 0.16 * (noise(160 * u, 160 * v, 6) - 0.5);
        if (noise(70 * u, 70 * v, 7) > 0.93) bright -= 0.14;  // pores
        bright -=
            0.22 * std::exp(-crack(u, v, 0.3, 2) / 0.0025) + 0.2 * std::exp(-crack(v, u, 0.65, 3) / 0.0025);
        // Joints of the slabs.
        if (std::min(std::abs(u - 0.5), std::abs(v - 0.5)) < 0.003) bright -= 0.15;
        return bright * Eigen::Vector3d(1.0, 0.98, 0.94);
    });
}

Texture makePlaster() {
    return painted(Edge, Edge, [](double u, double v) -> Eigen::Vector3d {
        double bright =
            0.84 + 0.14 * (cloudy(4 * u, 4 * v, 1) - 0.5) + 0.05 * (noise(120 * u, 120 * v, 6) - 0.5);
        bright -= 0.18 * std::exp(-crack(u, v, 0.55, 4) / 0.002);
        return bright * Eigen::Vector3d(1.0, 0.98, 0.92);
    });
}

Texture makeNewspaper() {
    return painted(96, 96, [](double u, double v) -> Eigen::Vector3d {
        const Eigen::Vector3d paper(0.86, 0.84, 0.77);
        if (v > 0.86 && v < 0.95 && hashAt(static_cast<int>(u * 40), 1, 1) > 0.4) return 0.2 * paper;
        if (u > 0.36 && u < 0.64 && v > 0.4 && v < 0.75) return (0.2 + 0.6 * cloudy(9 * u, 9 * v, 2)) * paper;
        const double column = u * 4.0 - std::floor(u * 4.0);
        const bool line = std::fmod(v * 36.0, 1.0) > 0.5 && v < 0.82;
        const bool ink = hashAt(static_cast<int>(u * 90), static_cast<int>(v * 36), 3) > 0.25;
        return column > 0.08 && column < 0.94 && line && ink ? Eigen::Vector3d(0.45 * paper) : paper;
    });
}

Texture makeCloth() {
    return painted(160, 64, [](double u, double v) -> Eigen::Vector3d {
        const double weave = 0.06 * (noise(120 * u, 60 * v, 1) - 0.5);
        const double stripe = std::fmod(u * 10.0, 1.0);
        const Eigen::Vector3d ground(0.30, 0.38, 0.58);
        const Eigen::Vector3d light(0.72, 0.70, 0.62);
        return (stripe < 0.3 ? light : ground) + Eigen::Vector3d::Constant(weave);
    });
}

}  // namespace

const Texture& plywoodTexture() {
    static const Texture picture = makePlywood();
    return picture;
}

const Texture& concreteTexture() {
    static const Texture picture = makeConcrete();
    return picture;
}

const Texture& plasterTexture() {
    static const Texture picture = makePlaster();
    return picture;
}

const Texture& newspaperTexture() {
    static const Texture picture = makeNewspaper();
    return picture;
}

const Texture& clothTexture() {
    static const Texture picture = makeCloth();
    return picture;
}

}  // namespace leitstand::simulation
