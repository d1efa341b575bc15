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
#include "widgets/models/camera/camera_words.h"
#include "widgets/models/live/robots/proximity.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/painting/pane_paint.h"

namespace leitstand {

/// What is drawn into a camera's picture; what is not known is empty and not drawn.
struct CameraOverlay {
    std::optional<ModeLabel> mode;
    std::optional<double> roll, pitch;  ///< of the robot: right side down, nose down [rad]
    PanWords turn;                      ///< of the camera
    std::optional<double> wishedPan;    ///< where it is on its way to [rad]
    double panLimit = 1.75;             ///< to each side [rad]
    double viewAngle = 0.9;             ///< from the left to the right border of the picture [rad]
    QStringList notes;                  ///< what was done to the picture: "contrast raised"
    std::vector<Proximity> ring;        ///< proximityRing(); empty: none
    bool moving = false;                ///< a camera turned aside deserves a look then
};

/// A camera of a robot: its picture as large as it fits, how old it is, and over it what the driver has to
/// know without looking away. Pictures that are stale are grey, lost ones are hardly seen.
class CameraPane final : public QWidget {
    Q_OBJECT
public:
    explicit CameraPane(QWidget* parent = nullptr);

    /// Whose camera this is, and what it is called: "Left camera".
    void setCamera(const RobotFace& face, const QString& title);
    void setPicture(const QImage& picture);
    /// There is no camera for this pane: an empty one is calm.
    void setVacant(bool vacant);
    /// Temperatures instead of a picture: with a scale, and the value under the pointer.
    void setThermal(std::shared_ptr<const ThermalPicture> picture, const ThermalRange& range = {},
                    ThermalPalette palette = ThermalPalette::Iron);
    /// Warm things in the thermal picture, framed.
    void setHeat(const std::vector<HeatBlob>& blobs);
    /// From which age a picture is old.
    void setLimits(const FreshnessLimits& limits) { m_head.limits = limits; }
    /// How old the picture is, PictureAge::at(); @p note stands after it: "full speed".
    void setAge(const DataAge& age, const QString& note = {});
    void setOverlay(const CameraOverlay& overlay);
    /// The picture is one all around: directions are marked along it. Empty: it is none.
    void setPanorama(const std::optional<PanoramaShape>& shape);
    /// Where the robot's front is in an omnidirectional picture, 0 to 1 of both sides; empty: unmarked.
    void setFront(const std::optional<QPointF>& ahead);
    /// Whether dragging the picture turns the camera.
    void setTurnable(bool turnable);
    /// The next click points at something, as clicks with Shift always do.
    void setPointing(bool pointing);

    /// Where the picture is painted [px]; empty without one.
    [[nodiscard]] QRectF pictureArea() const;
    [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 140}; }

signals:
    /// The operator pointed at @p place, 0 to 1 of the picture's width and height.
    void pointedAt(const QPointF& place);
    void pointingEnded();  ///< by the right button: at nothing
    /// The picture was clicked at @p x, @p y, 0 to 1 of its width and height.
    void pictureClicked(double x, double y);
    /// A camera that can be turned was taken hold of at @p from; places as above, @p to maybe outside. Told
    /// again while the pointer moves; @p first: a new hold.
    void pictureDragged(const QPointF& from, const QPointF& to, bool first);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    /// The next picture is about to come: what lies over this one is painted with it.
    [[nodiscard]] bool nextIsNear() const;
    void showCursor();
    void paintPicture(QPainter& painter, Freshness freshness);
    void scalePicture(const QSize& size, bool grey);
    void paintThermal(QPainter& painter, bool live) const;
    [[nodiscard]] QPointF inPicture(const QPointF& pixel) const;  ///< 0 to 1
    [[nodiscard]] QRectF overlayArea() const;

    PaneHead m_head;
    QImage m_picture;
    QImage m_scaled;  ///< m_picture as it is painted, made when it is needed
    bool m_scaledGrey = false;
    std::shared_ptr<const ThermalPicture> m_thermal;
    ThermalRange m_thermalRange;
    ThermalPalette m_palette = ThermalPalette::Iron;
    std::vector<HeatBlob> m_heat;
    CameraOverlay m_overlay;
    std::optional<PanoramaShape> m_panorama;
    std::optional<QPointF> m_front;
    bool m_turnable = false, m_dragging = false, m_pointing = false;
    std::optional<QPointF> m_pressed;  ///< where the button went down [px]
    bool m_points = false;             ///< Shift was held then
    std::optional<QPointF> m_pointer;
};

}  // namespace leitstand
