#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/live/robots/proximity.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// The local virtual 2D scan, robot up (paper, section 2.3; design, section 7): walls, obstacles, footprint,
/// range rings, where the robot goes as commanded, and how near the nearest thing is. What was looked at
/// longer ago is fainter. The wheel zooms, so do + and -; a double click resets.
class VirtualScanPane final : public QWidget {
    Q_OBJECT
public:
    explicit VirtualScanPane(QWidget* parent = nullptr);

    /// Whose surroundings these are. @p footprint: base_link [m].
    void setRobot(const RobotFace& face, const std::vector<Eigen::Vector2d>& footprint);
    /// Shows @p view at @p commanded; @p age [s]: since scans arrived last, infinite: never. A view of the
    /// same moment is not painted again until its age has grown by 0.1 s.
    void show(const std::optional<VirtualScanView>& view, const DriveVelocity& commanded, double age);
    using QWidget::show;

    static constexpr double NearestRange = 1.5, FarthestRange = 20.0, UsualRange = 4.0;  ///< [m]
    [[nodiscard]] double range() const { return m_range; }  ///< as far as is seen ahead [m]
    /// From which age the scan is stale and lost.
    void setLimits(const FreshnessLimits& limits) { m_head.limits = limits; }
    void setRange(double metres);  ///< within the bounds
    /// Whether what plane lasers measured is drawn over the contours; it is, at first.
    void setLaserShown(bool shown);

    /// Where a point of base_link is painted [px].
    [[nodiscard]] QPointF pixelOf(const Eigen::Vector2d& point) const;
    [[nodiscard]] Eigen::Vector2d pointOf(const QPointF& pixel) const;  ///< the other way round [m]
    /// The next click points at something, as clicks with Shift always do.
    void setPointing(bool pointing);
    [[nodiscard]] QSize sizeHint() const override { return {320, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 140}; }

signals:
    void pointedAt(const Eigen::Vector2d& place);  ///< base_link [m]
    void pointingEnded();                          ///< by the right button: at nothing

protected:
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] bool shows(const std::optional<VirtualScanView>& view, const DriveVelocity& commanded,
                             double age) const;

    PaneHead m_head;
    std::vector<Eigen::Vector2d> m_footprint;
    BodyBox m_body;
    std::optional<VirtualScanView> m_view;
    DriveVelocity m_commanded;
    double m_range = UsualRange;
    bool m_pointing = false;
    bool m_laser = true;
};

}  // namespace leitstand
