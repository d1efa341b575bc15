#include "core/perception/heat/body_heat.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace leitstand {
namespace {

/// Pixels of @p blob, and the lukewarm ones around that are connected to it.
class Flood {
public:
    Flood(const ThermalPicture& picture, const HeatBlob& blob, double lukewarm, double warm, int reach)
        : m_picture(picture),
          m_least(static_cast<float>(lukewarm)),
          m_warm(static_cast<float>(warm)),
          m_distance(picture.celsius.size(), Far) {
        // Starts from all pixels in the blob's box that are as warm as skin.
        for (int y = std::max(0, blob.top); y <= std::min(picture.height - 1, blob.bottom); ++y) {
            for (int x = std::max(0, blob.left); x <= std::min(picture.width - 1, blob.right); ++x) {
                if (at(x, y) >= m_warm) push(x, y, 0);
            }
        }
        for (std::size_t i = 0; i < m_open.size(); ++i) spread(m_open[i], reach);
    }
    struct Clothes {
        int pixels = 0;
        bool cut = false;  ///< by the picture's border
    };
    /// Returns the lukewarm pixels beyond the mixed ones around the warm ones.
    [[nodiscard]] Clothes clothes(double mixed) const {
        Clothes result;
        for (const int place : m_open) {
            const auto away = static_cast<double>(m_distance[static_cast<std::size_t>(place)]);
            if (away <= mixed || m_picture.celsius[static_cast<std::size_t>(place)] >= m_warm) continue;
            ++result.pixels;
            const int x = place % m_picture.width, y = place / m_picture.width;
            result.cut =
                result.cut || x == 0 || y == 0 || x + 1 == m_picture.width || y + 1 == m_picture.height;
        }
        return result;
    }

private:
    static constexpr int Far = 1 << 20;
    [[nodiscard]] float at(int x, int y) const {
        return m_picture.celsius[static_cast<std::size_t>(y * m_picture.width + x)];
    }
    void push(int x, int y, int distance) {
        const int place = y * m_picture.width + x;
        int& known = m_distance[static_cast<std::size_t>(place)];
        if (known != Far) return;
        known = distance;
        m_open.push_back(place);
    }
    void spread(int place, int reach) {
        const int x = place % m_picture.width, y = place / m_picture.width;
        const int distance = m_distance[static_cast<std::size_t>(place)];
        if (distance >= reach) return;
        for (int v = std::max(0, y - 1); v <= std::min(m_picture.height - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(m_picture.width - 1, x + 1); ++u) {
                if (at(u, v) >= m_least) push(u, v, at(u, v) >= m_warm ? 0 : distance + 1);
            }
        }
    }
    const ThermalPicture& m_picture;
    float m_least, m_warm;
    std::vector<int> m_distance;  ///< from the warm pixels [px]
    std::vector<int> m_open;
};

}  // namespace

BodyHeat judgeBody(const ThermalPicture& picture, const HeatBlob& blob, double range,
                   const BodyHeatSettings& settings) {
    BodyHeat body;
    const auto count = static_cast<std::size_t>(std::max(0, picture.width)) *
                       static_cast<std::size_t>(std::max(0, picture.height));
    if (count == 0 || picture.celsius.size() != count || !(range > 0.0) || blob.pixels <= 0) return body;
    const double pixel = blob.size / std::sqrt(static_cast<double>(blob.pixels)) * range;  // [m]
    body.across = blob.size * range;
    const double air = surroundings(picture);
    const double warm = std::max(HeatSettings{}.coolest, air + HeatSettings{}.contrast);
    const int reach = static_cast<int>(std::ceil(0.7 / std::max(1e-4, pixel)));
    const Flood flood(picture, blob, air + settings.lukewarm, warm, std::min(reach, picture.width));
    const Flood::Clothes clothes = flood.clothes(settings.mixed);
    body.clothes = clothes.pixels * pixel * pixel;
    body.clothesCut = clothes.cut;
    if (body.across < settings.smallest || body.across > settings.largest) {
        body.likelihood = 0.1;
        return body;
    }
    const double dressed = std::clamp(body.clothes / settings.clothes, 0.0, 1.0);
    body.likelihood = 0.25 + 0.7 * dressed;
    return body;
}

}  // namespace leitstand
