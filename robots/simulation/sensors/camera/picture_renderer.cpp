#include "robots/simulation/sensors/camera/picture_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace leitstand::simulation {
namespace {

constexpr float Nearest = 0.02F;  ///< [m]
constexpr double Gamma = 2.2;
constexpr std::size_t ShadowStep = 2;  ///< one ray for so many pixels of a row
constexpr float ShadowGap = 0.004F;    ///< above what is shaded [m]
constexpr float ShadowReach = 6.0F;    ///< [m]

/// Returns the linear light of encoded colours, 0 to 255.
const std::array<float, 256>& linearOf() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<float>(std::pow(double(i) / 255.0, Gamma));
        }
        return values;
    }();
    return table;
}

/// Returns the pixel value of linear light from 0 to 1.
std::uint8_t encoded(float light) {
    static const std::array<std::uint8_t, 4097> table = [] {
        std::array<std::uint8_t, 4097> values{};
        for (std::size_t i = 0; i < values.size(); ++i) {
            values[i] = static_cast<std::uint8_t>(
                std::lround(255.0 * std::pow(double(i) / double(values.size() - 1), 1.0 / Gamma)));
        }
        return values;
    }();
    return table[light > 0.0F ? static_cast<std::size_t>(std::min(light, 1.0F) * 4096.0F) : 0];
}

Eigen::Vector3f linear(const Eigen::Vector3f& colour) {
    Eigen::Vector3f light;
    for (int i = 0; i < 3; ++i) {
        light[i] = linearOf()[static_cast<std::size_t>(std::clamp(colour[i], 0.0F, 1.0F) * 255.0F)];
    }
    return light;
}

/// Returns the light that a texture reflects at @p uv, interpolated between its four nearest pixels.
Eigen::Vector3f sampled(const Texture& texture, const Eigen::Vector2f& uv) {
    const float x = uv.x() * static_cast<float>(texture.width) - 0.5F;
    const float y = (1.0F - uv.y()) * static_cast<float>(texture.height) - 0.5F;
    const auto column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
    const float right = x - static_cast<float>(column), down = y - static_cast<float>(row);
    const auto pixel = [&](int dx, int dy) {
        const int u = std::clamp(column + dx, 0, texture.width - 1);
        const int v = std::clamp(row + dy, 0, texture.height - 1);
        const std::uint8_t* p = &texture.pixels[3 * static_cast<std::size_t>(v * texture.width + u)];
        return Eigen::Vector3f(linearOf()[p[0]], linearOf()[p[1]], linearOf()[p[2]]);
    };
    return (1.0F - down) * ((1.0F - right) * pixel(0, 0) + right * pixel(1, 0)) +
           down * ((1.0F - right) * pixel(0, 1) + right * pixel(1, 1));
}

Eigen::Vector3f pointOf(const Hit& hit, const Ray& ray) {
    return ray.origin + hit.distance * ray.direction;
}

/// Returns the light that a ray brings. @p sunny: share of the hall's direct light that arrives.
Eigen::Vector3f lightOf(const Hit& hit, const Ray& ray, const LightField& light, float sunny) {
    if (!hit.there()) return light.outside(ray.direction);
    const bool painted = hit.texture != nullptr && hit.texture->width > 0 && hit.texture->height > 0;
    const Eigen::Vector3f paint = painted ? sampled(*hit.texture, hit.uv) : linear(hit.surface->colour);
    const float around = light.at(pointOf(hit, ray), hit.normal) + sunny * light.direct(hit.normal);
    return paint * (around + hit.surface->glow);
}

}  // namespace

std::vector<Eigen::Vector3f> pixelDirections(const CameraModel& camera) {
    std::vector<Eigen::Vector3f> directions;
    directions.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
    for (int row = 0; row < camera.height; ++row) {
        for (int column = 0; column < camera.width; ++column) {
            const auto direction = camera.direction({column, row});
            directions.push_back(direction ? direction->cast<float>()
                                           : Eigen::Vector3f(Eigen::Vector3f::Zero()));
        }
    }
    return directions;
}

PictureRenderer::PictureRenderer(const CameraModel& camera, const Noise& noise,
                                 const ExposureSettings& settings)
    : m_noise(noise), m_settings(settings) {
    setCamera(camera);
}

void PictureRenderer::setCamera(const CameraModel& camera) {
    m_camera = camera;
    m_directions = pixelDirections(camera);
    m_light.resize(m_directions.size());
    m_pixels.resize(3 * m_directions.size());
    m_rays.resize(static_cast<std::size_t>(camera.width));
    m_hits.resize(static_cast<std::size_t>(camera.width));
    m_shadowRays.resize((m_rays.size() + ShadowStep - 1) / ShadowStep);
    m_shadowHits.resize(m_shadowRays.size());
    m_vignette.resize(m_directions.size());
    const Eigen::Vector2f middle(static_cast<float>(camera.width - 1) / 2.0F,
                                 static_cast<float>(camera.height - 1) / 2.0F);
    for (std::size_t i = 0; i < m_vignette.size(); ++i) {
        const auto width = static_cast<std::size_t>(camera.width);
        const Eigen::Vector2f pixel(static_cast<float>(i % width), static_cast<float>(i / width));
        const float off = (pixel - middle).squaredNorm() / middle.squaredNorm();
        m_vignette[i] = 1.0F - m_settings.vignetting * off;
    }
}

void PictureRenderer::castRow(const Pose& cameraInArena, int row, const CastRays& cast) {
    const Eigen::Matrix3f turn = cameraInArena.linear().cast<float>();
    const Eigen::Vector3f origin = cameraInArena.translation().cast<float>();
    const std::size_t first = static_cast<std::size_t>(row) * m_rays.size();
    for (std::size_t i = 0; i < m_rays.size(); ++i) {
        const Eigen::Vector3f& direction = m_directions[first + i];
        // Rays without a direction end at once.
        const bool blind = direction.isZero();
        m_rays[i] = {origin,
                     blind ? Eigen::Vector3f(Eigen::Vector3f::UnitX()) : Eigen::Vector3f(turn * direction),
                     blind ? 0.0F : Nearest, blind ? 0.0F : 100.0F};
    }
    cast(m_rays, m_hits);
}

void PictureRenderer::castShadows(const CastRays& cast) {
    const Eigen::Vector3f& hall = LightField::towardsHall();
    for (std::size_t i = 0; i < m_shadowRays.size(); ++i) {
        const Hit& hit = m_hits[ShadowStep * i];
        const bool lit = hit.there() && hit.normal.dot(hall) > 0.0F;
        m_shadowRays[i] = {
            lit ? Eigen::Vector3f(pointOf(hit, m_rays[ShadowStep * i]) + ShadowGap * hit.normal)
                : Eigen::Vector3f(Eigen::Vector3f::Zero()),
            hall, 0.0F, lit ? ShadowReach : 0.0F};
    }
    cast(m_shadowRays, m_shadowHits);
}

float PictureRenderer::sunnyAt(std::size_t column) const {
    const std::size_t left = column / ShadowStep, right = std::min(left + 1, m_shadowHits.size() - 1);
    const float here = m_shadowHits[left].there() ? 0.0F : 1.0F;
    if (column % ShadowStep == 0) return here;
    return 0.5F * (here + (m_shadowHits[right].there() ? 0.0F : 1.0F));
}

const std::vector<std::uint8_t>& PictureRenderer::render(const Pose& cameraInArena, const CastRays& cast,
                                                         const LightField& light) {
    double sum = 0.0;
    std::size_t seen = 0;
    for (int row = 0; row < m_camera.height; ++row) {
        castRow(cameraInArena, row, cast);
        castShadows(cast);
        const std::size_t first = static_cast<std::size_t>(row) * m_rays.size();
        for (std::size_t i = 0; i < m_rays.size(); ++i) {
            Eigen::Vector3f& pixel = m_light[first + i];
            if (!(m_rays[i].far > 0.0F)) {
                pixel.setZero();
                continue;
            }
            pixel = m_vignette[first + i] * lightOf(m_hits[i], m_rays[i], light, sunnyAt(i));
            sum += std::min(1.0, double{pixel.y()});  // lamps do not close the iris
            ++seen;
        }
    }
    const float mean = seen == 0 ? 1.0F : static_cast<float>(sum / static_cast<double>(seen));
    const float wanted = std::pow(m_settings.brightness, static_cast<float>(Gamma)) / std::max(mean, 1e-4F);
    const float right = std::clamp(wanted, m_settings.leastGain, m_settings.mostGain);
    m_gain = m_gain > 0.0F ? m_gain + m_settings.adaption * (right - m_gain) : right;
    develop();
    return m_pixels;
}

void PictureRenderer::develop() {
    const float noise = m_settings.noise * std::sqrt(m_gain);
    for (std::size_t i = 0; i < m_light.size(); ++i) {
        const float grain = m_directions[i].isZero() ? 0.0F : noise * m_noise.quickNormal();
        for (int channel = 0; channel < 3; ++channel) {
            const float light = m_gain * m_light[i][channel];
            m_pixels[3 * i + static_cast<std::size_t>(2 - channel)] = encoded(light + grain * (0.3F + light));
        }
    }
}

}  // namespace leitstand::simulation
