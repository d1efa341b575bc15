#include "widgets/map_view/robots/body_overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <QImage>
#include <QPainter>
#include <QPolygonF>

#include "core/robot/model/model_body.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/overlays/overlay_style.h"
#include "widgets/models/map/robots/robot_mark.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {
namespace {

/// A corner of a triangle on screen.
struct Corner {
    Eigen::Vector2f at;     ///< [px] in the image
    float nearness = 0.0F;  ///< greater nearer to the eye; linear on screen
};

/// Returns how bright a side with normal @p outward is: it is lit from above, ahead of the eye and a little
/// from one side, so that neighbours differ.
float lightOf(const Eigen::Vector3f& outward, const Eigen::Vector3f& toEye) {
    const float above = 0.28F * outward.z();
    const float aside = 0.08F * outward.x() + 0.05F * outward.y();
    return std::clamp(0.45F + above + aside + 0.30F * std::abs(outward.dot(toEye)), 0.15F, 1.15F);
}

QRgb shaded(const PartColour& colour, float light, bool grey) {
    Eigen::Vector3f rgb = colour;
    if (grey) rgb.setConstant(0.3F * rgb.x() + 0.59F * rgb.y() + 0.11F * rgb.z());
    // Black parts keep some shape.
    rgb = (0.13F + 0.87F * rgb.array()).matrix() * light;
    const Eigen::Vector3i bytes = (255.0F * rgb.cwiseMin(1.0F)).cast<int>();
    return qRgb(bytes.x(), bytes.y(), bytes.z());
}

/// A picture of triangles, in which nearer ones hide others.
class Canvas {
public:
    explicit Canvas(QSize size)
        : m_image(size, QImage::Format_ARGB32_Premultiplied),
          m_nearness(static_cast<std::size_t>(size.width()) * static_cast<std::size_t>(size.height()),
                     -std::numeric_limits<float>::infinity()) {
        m_image.fill(Qt::transparent);
    }

    /// False: filling costs too much time, and is given up.
    [[nodiscard]] bool fill(const std::array<Corner, 3>& corners, QRgb colour) {
        const auto& [a, b, c] = corners;
        const float area = edge(a.at, b.at, c.at);
        if (std::abs(area) < 1e-6F) return true;
        const Eigen::Vector2f least = a.at.cwiseMin(b.at).cwiseMin(c.at);
        const Eigen::Vector2f most = a.at.cwiseMax(b.at).cwiseMax(c.at);
        const int left = std::max(0, static_cast<int>(std::floor(least.x())));
        const int top = std::max(0, static_cast<int>(std::floor(least.y())));
        const int right = std::min(m_image.width() - 1, static_cast<int>(std::ceil(most.x())));
        const int bottom = std::min(m_image.height() - 1, static_cast<int>(std::ceil(most.y())));
        if (right < left || bottom < top) return true;
        m_spent += static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(bottom - top + 1);
        if (m_spent > MostSpent) return false;
        for (int y = top; y <= bottom; ++y) {
            auto* const line = reinterpret_cast<QRgb*>(m_image.scanLine(y));
            float* const nearness =
                m_nearness.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(m_image.width());
            for (int x = left; x <= right; ++x) {
                const Eigen::Vector2f at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                const float u = edge(b.at, c.at, at) / area, v = edge(c.at, a.at, at) / area;
                const float w = 1.0F - u - v;
                if (u < 0.0F || v < 0.0F || w < 0.0F) continue;
                const float here = u * a.nearness + v * b.nearness + w * c.nearness;
                if (here <= nearness[x]) continue;
                nearness[x] = here;
                line[x] = colour;
            }
        }
        return true;
    }
    [[nodiscard]] const QImage& image() const { return m_image; }

private:
    static float edge(const Eigen::Vector2f& from, const Eigen::Vector2f& to, const Eigen::Vector2f& at) {
        return (to - from).x() * (at - from).y() - (to - from).y() * (at - from).x();
    }

    static constexpr std::size_t MostSpent = 6'000'000;  ///< pixels that are looked at: some 20 ms

    QImage m_image;
    std::vector<float> m_nearness;
    std::size_t m_spent = 0;
};

/// A part of the body as it is seen.
struct SeenPart {
    const TriangleMesh* surface;
    std::vector<Eigen::Vector3f> inMap;
    std::vector<Corner> corners;  ///< one per vertex, in the widget until there is an image
};

std::optional<std::vector<SeenPart>> seenParts(const MapProjection& projection, const RobotMark& robot) {
    std::vector<SeenPart> parts;
    for (const BodyPart& part : robot.body->parts) {
        SeenPart& seen = parts.emplace_back(SeenPart{&part.surface, {}, {}});
        const Pose pose = robot.baseInMap * robot.linksInBase.at(part.link);
        for (const Eigen::Vector3f& vertex : part.surface.vertices) {
            const Eigen::Vector3d inMap = pose * vertex.cast<double>();
            const auto at = projection.project(inMap);
            // A joint may be where no number tells.
            if (!at || !inMap.allFinite()) return std::nullopt;
            const double nearness = projection.camera().parallel ? -at->depth : 1.0 / at->depth;
            seen.inMap.push_back(inMap.cast<float>());
            seen.corners.push_back(
                {{static_cast<float>(at->position.x()), static_cast<float>(at->position.y())},
                 static_cast<float>(nearness)});
        }
    }
    return parts;
}

QRectF boundsOf(const std::vector<SeenPart>& parts) {
    Eigen::AlignedBox2f box;
    for (const SeenPart& part : parts)
        for (const Corner& corner : part.corners) box.extend(corner.at);
    if (box.isEmpty()) return {};
    return QRectF(QPointF(box.min().x(), box.min().y()), QPointF(box.max().x(), box.max().y()))
        .adjusted(-3, -3, 3, 3);  // room for the rim
}

/// Paints @p parts into a picture of @p area of the widget, @p scale pixels of it for each logical one.
/// Empty: that would take too long.
QImage pictureOf(std::vector<SeenPart>& parts, const QRectF& area, double scale,
                 const MapProjection& projection, const BodyLook& look) {
    Canvas canvas((area.size() * scale).toSize().expandedTo(QSize(1, 1)));
    const Eigen::Vector2f origin(static_cast<float>(area.x()), static_cast<float>(area.y()));
    const Eigen::Vector3f eye = projection.camera().eye().cast<float>();
    const Eigen::Vector3f forward = projection.camera().forward().cast<float>();
    for (SeenPart& part : parts) {
        for (Corner& corner : part.corners) corner.at = (corner.at - origin) * static_cast<float>(scale);
        for (std::size_t i = 0; i < part.surface->triangles.size(); ++i) {
            const auto& [a, b, c] = part.surface->triangles[i];
            Eigen::Vector3f outward =
                (part.inMap[b] - part.inMap[a]).cross(part.inMap[c] - part.inMap[a]).normalized();
            const Eigen::Vector3f toEye =
                projection.camera().parallel ? -forward : (eye - part.inMap[a]).normalized();
            // The sides of triangles in CAD files are not always the right way round.
            if (outward.dot(toEye) < 0.0F) outward = -outward;
            if (!canvas.fill({part.corners[a], part.corners[b], part.corners[c]},
                             shaded(part.surface->colours[i], lightOf(outward, toEye), look.grey)))
                return {};
        }
    }
    return canvas.image();
}

QColor robotColour(const RobotMark& robot, const BodyLook& look, const OverlayStyle& style) {
    const QColor own = style.window->robot(robot.face.place);
    return look.grey ? greyed(own) : own;
}

/// Paints the footprint, and an arrow ahead of it, in the robot's colour.
void paintGround(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                 const BodyLook& look, const OverlayStyle& style) {
    if (robot.footprint.size() < 3) return;
    Eigen::AlignedBox2d plan;
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector2d& corner : robot.footprint) {
        plan.extend(corner);
        corners.emplace_back(robot.baseInMap * Eigen::Vector3d(corner.x(), corner.y(), 0.0));
    }
    const double size = 0.3 * plan.sizes().y(), front = plan.max().x() + 0.25 * size;
    const double middle = plan.center().y();
    std::vector<Eigen::Vector3d> arrow;
    for (const auto& [x, y] :
         {std::pair(front + size, middle), std::pair(front, middle + size), std::pair(front, middle - size)})
        arrow.emplace_back(robot.baseInMap * Eigen::Vector3d(x, y, 0.0));
    const QColor colour = robotColour(robot, look, style);
    const Qt::PenStyle line = look.opacity < 1.0 ? Qt::DashLine : Qt::SolidLine;
    painter.setBrush(Qt::NoBrush);
    const QPolygonF outline = projection.outline(corners);
    for (const QPen& pen : {QPen(asColour(style.colours.background), 4.0), QPen(colour, 2.0, line)}) {
        painter.setPen(pen);
        painter.drawPolygon(outline);
    }
    painter.setPen(QPen(asColour(style.colours.background), 1.5));
    painter.setBrush(colour);
    painter.drawPolygon(projection.outline(arrow));
}

/// Returns @p picture with a rim of @p width pixels in @p colour: dark parts are seen on dark ground, and
/// whose it is.
QImage rimmed(const QImage& picture, int width, const QColor& colour) {
    QImage shape = picture;
    QPainter tint(&shape);
    tint.setCompositionMode(QPainter::CompositionMode_SourceIn);
    tint.fillRect(shape.rect(), colour);
    tint.end();
    QImage result(picture.size(), QImage::Format_ARGB32_Premultiplied);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    const int aslant = std::max(1, qRound(0.7 * width));
    for (const QPoint& step :
         {QPoint(width, 0), QPoint(-width, 0), QPoint(0, width), QPoint(0, -width), QPoint(aslant, aslant),
          QPoint(-aslant, aslant), QPoint(aslant, -aslant), QPoint(-aslant, -aslant)})
        painter.drawImage(step, shape);
    painter.drawImage(QPoint(0, 0), picture);
    return result;
}

}  // namespace

bool paintModel(QPainter& painter, const MapProjection& projection, const RobotMark& robot,
                const BodyLook& look, const OverlayStyle& style) {
    constexpr double Finer = 2.0, Coarser = 1.0, Large = 400.0;  // pixels of the picture per pixel; [px]
    constexpr double MostPixels = 250'000.0;                     // of the picture
    if (!robot.body || robot.linksInBase.size() != robot.body->model.links.size()) return false;
    auto parts = seenParts(projection, robot);
    if (!parts) return false;
    const QRectF area = boundsOf(*parts).intersected(QRectF(QPointF(0, 0), QSizeF(projection.size())));
    if (area.isEmpty()) return true;
    const double finer = std::max(area.width(), area.height()) < Large ? Finer : Coarser;
    const double most = std::sqrt(MostPixels / std::max(area.width() * area.height(), 1.0));
    const double scale = std::min(finer * painter.device()->devicePixelRatioF(), most);
    const QImage picture = pictureOf(*parts, area, scale, projection, look);
    if (picture.isNull()) return false;
    paintGround(painter, projection, robot, look, style);
    painter.save();
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setOpacity(look.opacity);
    painter.drawImage(area,
                      rimmed(picture, std::max(1, qRound(1.3 * scale)), robotColour(robot, look, style)));
    painter.restore();
    return true;
}

}  // namespace leitstand
