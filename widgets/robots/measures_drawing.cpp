#include "widgets/robots/measures_drawing.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <QPainter>
#include <QPolygonF>

#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr double Margin = 16.0, Caption = 20.0;  // [px]
constexpr double LeastSize = 0.2;                // [m]
constexpr double Gaze = 18.0;                    // length of a sensor's direction [px]

/// A view of the robot: which of its axes lie to the right and up.
struct View {
    QString caption;
    std::function<Eigen::Vector2d(const Eigen::Vector3d&)> plane;
};

/// Returns where optical frames look; other sensors look along x.
Eigen::Vector3d gazeOf(const SensorPlace& sensor) {
    const bool optical = sensor.frame.find("optical") != std::string::npos;
    return sensor.sensorInBase.linear() * (optical ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitX());
}

class Plan {
public:
    Plan(QPainter& painter, const QRectF& area, const View& view, const Measures& measures)
        : m_painter(painter), m_area(area), m_view(view), m_measures(measures) {
        for (const Eigen::Vector2d& corner : measures.footprint)
            for (const double z : {0.0, measures.height})
                m_box.extend(view.plane({corner.x(), corner.y(), z}));
        for (const SensorPlace& sensor : measures.sensors)
            m_box.extend(view.plane(sensor.sensorInBase.translation()));
        m_box.extend(Eigen::Vector2d::Zero());
    }
    /// Scale at which the view fits its area [px/m].
    [[nodiscard]] double fitting() const {
        const Eigen::Vector2d size = m_box.sizes().cwiseMax(LeastSize);
        return std::min(m_area.width() / size.x(), m_area.height() / size.y());
    }
    void paint(double scale, const std::string& chosen) {
        m_scale = scale;
        const ThemeColours& colours = coloursOf(presentTheme());
        paintBody(colours);
        paintBase(colours);
        for (const SensorPlace& sensor : m_measures.sensors)
            if (sensor.name != chosen) paintSensor(sensor, colours.text, false);
        for (const SensorPlace& sensor : m_measures.sensors)
            if (sensor.name == chosen) paintSensor(sensor, colours.select, true);
        m_painter.setPen(colours.muted);
        m_painter.drawText(QRectF(m_area.left(), m_area.bottom() + 2.0, m_area.width(), Caption),
                           Qt::AlignCenter, m_view.caption);
    }

private:
    [[nodiscard]] QPointF at(const Eigen::Vector3d& point) const {
        const Eigen::Vector2d plane = m_view.plane(point) - m_box.center();
        return m_area.center() + QPointF(m_scale * plane.x(), -m_scale * plane.y());
    }

    void paintBody(const ThemeColours& colours) {
        // From the side it is as long as the outline and as high as it says.
        QPolygonF outline;
        for (const Eigen::Vector2d& corner : m_measures.footprint)
            outline << at({corner.x(), corner.y(), 0.0});
        const bool fromAbove = outline.boundingRect().height() > 1.0;
        if (!fromAbove) {
            const Sides sides = sidesOf(m_measures.footprint);
            outline =
                QPolygonF({at({sides.front, 0, 0}), at({-sides.rear, 0, 0}),
                           at({-sides.rear, 0, m_measures.height}), at({sides.front, 0, m_measures.height})});
            m_painter.setPen(QPen(colours.line, 1.0));
            const double ground = at({0, 0, 0}).y();
            m_painter.drawLine(QPointF(m_area.left(), ground), QPointF(m_area.right(), ground));
        }
        m_painter.setPen(QPen(colours.muted, 1.5));
        m_painter.setBrush(colours.field);
        m_painter.drawPolygon(outline);
    }

    void paintBase(const ThemeColours& colours) {
        constexpr double Length = 22.0;  // [px]
        m_painter.setBrush(Qt::NoBrush);
        const QPointF origin = at({0, 0, 0});
        for (const auto& [axis, name] : {std::pair(Eigen::Vector3d(Eigen::Vector3d::UnitX()), "x"),
                                         std::pair(Eigen::Vector3d(Eigen::Vector3d::UnitY()), "y"),
                                         std::pair(Eigen::Vector3d(Eigen::Vector3d::UnitZ()), "z")}) {
            const QPointF along = at(axis) - origin;
            const double length = std::hypot(along.x(), along.y());
            if (length < 1.0) continue;
            const QPointF end = origin + along * (Length / length);
            m_painter.setPen(QPen(colours.muted, 1.5));
            m_painter.drawLine(origin, end);
            m_painter.drawText(QRectF(end - QPointF(8, 8), QSizeF(16, 16)).translated(along * (9.0 / length)),
                               Qt::AlignCenter, QLatin1String(name));
        }
    }

    void paintSensor(const SensorPlace& sensor, const QColor& colour, bool chosen) {
        const QPointF place = at(sensor.sensorInBase.translation());
        const QPointF along = at(sensor.sensorInBase.translation() + gazeOf(sensor)) - place;
        m_painter.setPen(QPen(colour, chosen ? 2.5 : 1.5));
        m_painter.setBrush(colour);
        m_painter.drawEllipse(place, 3.5, 3.5);
        const double length = std::hypot(along.x(), along.y());
        if (length > 0.3 * m_scale) m_painter.drawLine(place, place + along * (Gaze / length));
        const QString name = othersText(sensor.name);
        const QFontMetricsF metrics(m_painter.font());
        QRectF box(place + QPointF(7, -metrics.height() - 2.0),
                   QSizeF(metrics.horizontalAdvance(name), metrics.height()));
        // Names of sensors at nearly the same place stand below each other.
        while (std::any_of(m_taken.begin(), m_taken.end(),
                           [&](const QRectF& one) { return one.intersects(box); }))
            box.translate(0.0, metrics.height());
        m_taken.push_back(box);
        m_painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter, name);
    }

    QPainter& m_painter;
    QRectF m_area;
    const View& m_view;
    const Measures& m_measures;
    Eigen::AlignedBox2d m_box;
    double m_scale = 1.0;
    std::vector<QRectF> m_taken;  ///< by names
};

}  // namespace

MeasuresDrawing::MeasuresDrawing(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("The robot from above and from its right side"));
}

void MeasuresDrawing::show(const Measures& measures, const std::string& chosen) {
    m_measures = measures;
    m_chosen = chosen;
    const Sides sides = sidesOf(measures.footprint);
    setAccessibleDescription(tr("%1 m long, %2 m wide, %3 m high")
                                 .arg(numberText(sides.front + sides.rear, 2),
                                      numberText(sides.left + sides.right, 2),
                                      numberText(measures.height, 2)));
    update();
}

void MeasuresDrawing::paintEvent(QPaintEvent* /*event*/) {
    if (m_measures.footprint.size() < 3) return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(sized(painter.font(), 12));
    const View above{tr("from above"),
                     [](const Eigen::Vector3d& point) { return Eigen::Vector2d(point.x(), point.y()); }};
    const View side{tr("from the right"),
                    [](const Eigen::Vector3d& point) { return Eigen::Vector2d(point.x(), point.z()); }};
    const double half = 0.5 * width();
    const QRectF left(Margin, Margin, half - 2.0 * Margin, height() - 2.0 * Margin - Caption);
    Plan plan(painter, left, above, m_measures),
        profile(painter, left.translated(half, 0.0), side, m_measures);
    // Ahead is to the right in both, at one scale.
    const double scale = 0.9 * std::min(plan.fitting(), profile.fitting());
    plan.paint(scale, m_chosen);
    profile.paint(scale, m_chosen);
}

}  // namespace leitstand
