#pragma once

#include <optional>
#include <vector>

#include <QWidget>

#include "widgets/models/live/robots/proximity.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// Shows the local virtual 2D scan with the robot's front up (paper, section 2.3; docs/design.md, "The
/// window"). It draws walls, obstacles, footprint, range rings, the commanded path, and the nearest obstacle
/// with its distance. Older data is fainter. The wheel, + and - zoom; a double click resets.
class VirtualScanPane final : public QWidget {
    Q_OBJECT
public:
    explicit VirtualScanPane(QWidget* parent = nullptr);

    /// Sets the robot whose surroundings are shown. @p footprint: base_link [m].
    void setRobot(const RobotFace& face, const std::vector<Eigen::Vector2d>& footprint);
    /// Shows @p view with the velocity @p commanded. @p age: since the last scan was received [s]; infinite:
    /// never. The same view and velocity are painted again only if the age changed by 0.1 s.
    void show(const std::optional<VirtualScanView>& view, const DriveVelocity& commanded, double age);
    using QWidget::show;

    /// Least, largest and usual distance that is visible ahead [m].
    static constexpr double NearestRange = 1.5, FarthestRange = 20.0, UsualRange = 4.0;
    [[nodiscard]] double range() const { return m_range; }  ///< visible distance ahead [m]
    /// Sets the ages from which the scan is stale or lost.
    void setLimits(const FreshnessLimits& limits) { m_head.limits = limits; }
    void setRange(double metres);  ///< limited to NearestRange .. FarthestRange [m]
    /// Sets whether the points of planar lasers are drawn; at first they are.
    void setLaserShown(bool shown);

    /// Returns where a point of base_link is painted [px].
    [[nodiscard]] QPointF pixelOf(const Eigen::Vector2d& point) const;
    [[nodiscard]] Eigen::Vector2d pointOf(const QPointF& pixel) const;  ///< inverse of pixelOf() [m]
    /// While on, clicks point at something: they emit pointedAt(). Clicks with Shift always do this.
    void setPointing(bool pointing);
    [[nodiscard]] QSize sizeHint() const override { return {320, 300}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 140}; }

signals:
    void pointedAt(const Eigen::Vector2d& place);  ///< place in base_link [m]
    void pointingEnded();                          ///< ended by the right button, without a place

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
