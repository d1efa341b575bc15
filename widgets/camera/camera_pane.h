#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QStringList>
#include <QWidget>

#include "core/perception/heat/heat.h"
#include "core/perception/pictures/picture.h"
#include "widgets/camera/picture_image.h"
#include "widgets/models/camera/camera_text.h"
#include "widgets/models/camera/detection_marks.h"
#include "widgets/models/live/robots/proximity.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// What is drawn over a camera's picture. Unknown values are empty and not drawn.
struct CameraOverlay {
    std::optional<ModeLabel> mode;
    /// Roll and pitch of the robot; positive: right side or nose down [rad].
    std::optional<double> roll, pitch;
    PanWords turn;                       ///< where the camera looks, and how to turn it
    std::optional<double> requestedPan;  ///< pan to which the camera is turning [rad]
    double panLimit = 1.75;              ///< largest pan to each side [rad]
    double viewAngle = 0.9;              ///< angle from the left to the right edge of the picture [rad]
    QStringList notes;                   ///< how the picture was processed: "contrast raised"
    std::vector<DetectionMark> detections;
    std::vector<Proximity> ring;  ///< proximityRing(); empty: none
    bool moving = false;  ///< whether the robot moves; then a camera that is turned aside is highlighted
};

/// Shows a camera of a robot: its picture as large as possible, the picture's age, and an overlay for the
/// driver. Old pictures are grey; very old ones are almost invisible.
class CameraPane final : public QWidget {
    Q_OBJECT
public:
    explicit CameraPane(QWidget* parent = nullptr);

    /// Sets the robot that has the camera, and the camera's title: "Left camera".
    void setCamera(const RobotFace& face, const QString& title);
    void setPicture(const QImage& picture);
    /// Sets whether the pane has no camera; then it shows neither age nor loss.
    void setVacant(bool vacant);
    /// Shows temperatures instead of a picture, with a scale and the value under the pointer.
    void setThermal(std::shared_ptr<const ThermalPicture> picture, const ThermalRange& range = {},
                    ThermalPalette palette = ThermalPalette::Iron);
    /// Frames warm things in the thermal picture.
    void setHeat(const std::vector<HeatBlob>& blobs);
    /// Sets the ages from which a picture is stale or lost.
    void setLimits(const FreshnessLimits& limits) { m_head.limits = limits; }
    /// Sets the picture's age (PictureAge::at()). @p note is shown after it: "full speed".
    void setAge(const DataAge& age, const QString& note = {});
    void setOverlay(const CameraOverlay& overlay);
    /// Marks directions in the picture, which is a panorama of @p shape. Empty: it is no panorama.
    void setPanorama(const std::optional<PanoramaShape>& shape);
    /// Marks the robot's front in an omnidirectional picture, as shares of width and height (0 to 1). Empty:
    /// no mark.
    void setFront(const std::optional<QPointF>& ahead);
    /// Sets whether dragging the picture turns the camera.
    void setTurnable(bool turnable);
    /// While on, clicks point at something: they emit pointedAt(). Clicks with Shift always do this.
    void setPointing(bool pointing);

    /// Returns where the picture is painted [px]; empty: there is no picture.
    [[nodiscard]] QRectF pictureArea() const;
    [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 140}; }

signals:
    /// The operator pointed at @p place in the picture, as shares of width and height (0 to 1).
    void pointedAt(const QPointF& place);
    void pointingEnded();  ///< ended by the right button, without a place
    /// The picture was clicked at (@p x, @p y), as shares of width and height (0 to 1).
    void pictureClicked(double x, double y);
    /// The operator drags the picture of a turnable camera from @p from to @p to, as shares of width and
    /// height (0 to 1); @p to may be outside. Emitted at each move of the pointer. @p first: whether it is
    /// the first move of a drag.
    void pictureDragged(const QPointF& from, const QPointF& to, bool first);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// Whether the next picture will arrive soon. Changes of the overlay are then painted together with it.
    [[nodiscard]] bool nextIsNear() const;
    void showCursor();
    void paintPicture(QPainter& painter, Freshness freshness);
    void scalePicture(const QSize& size, bool grey);
    void paintThermal(QPainter& painter, bool live) const;
    [[nodiscard]] QPointF inPicture(const QPointF& pixel) const;  ///< as shares of width and height (0 to 1)
    [[nodiscard]] QRectF overlayArea() const;

    PaneHead m_head;
    QImage m_picture;
    QImage m_scaled;  ///< m_picture in the size in which it is painted; made when needed
    bool m_scaledGrey = false;
    std::shared_ptr<const ThermalPicture> m_thermal;
    ThermalRange m_thermalRange;
    ThermalPalette m_palette = ThermalPalette::Iron;
    std::vector<HeatBlob> m_heat;
    CameraOverlay m_overlay;
    std::optional<PanoramaShape> m_panorama;
    std::optional<QPointF> m_front;
    bool m_turnable = false, m_dragging = false, m_pointing = false;
    std::optional<QPointF> m_pressed;  ///< where the button was pressed [px]
    bool m_points = false;             ///< whether Shift was held when the button was pressed
    std::optional<QPointF> m_pointer;
};

}  // namespace leitstand
