#pragma once

#include <functional>

#include <QImage>

#include "widgets/map_view/map_view.h"

namespace leitstand::test {

/// A map view on a screen that nobody sees, and what an operator does with it.
class ShownView {
public:
    explicit ShownView(MapPtr map = nullptr, const MapViewSettings& settings = {}, QSize size = {480, 300});

    MapView& operator*() { return m_view; }
    MapView* operator->() { return &m_view; }

    /// Changes the settings and waits until the picture shows them.
    void set(const MapViewSettings& settings);
    void alter(const std::function<void(MapViewSettings&)>& change);
    /// Waits until the picture on screen is complete; returns false, and fails the test, when it never is.
    bool settle();
    /// What is on screen now.
    [[nodiscard]] QImage onScreen() { return m_view.grab().toImage(); }

    void drag(Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {});
    void wheel(QPoint position, int notches);
    void click(QPoint position);
    void hover(QPoint position);
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {});

    /// Where a point of the map is on screen; fails the test when it is not.
    [[nodiscard]] QPointF at(const Eigen::Vector3d& pointInMap);

private:
    MapView m_view;
};

/// Settings that are the default ones but for these.
[[nodiscard]] MapViewSettings settingsOf(MapLook look, MapColouring colouring = MapColouring::Label,
                                         Theme theme = Theme::Dark);
/// Voxels with edges of @p size [m].
[[nodiscard]] MapViewSettings voxelsOf(double size);

/// Whether @p condition came true within ten seconds of handling events.
bool waitFor(const std::function<bool()>& condition);

/// Pixels of @p colour, but for the overlays along the lower edge; each channel may be @p tolerance off.
[[nodiscard]] int countPixels(const QImage& image, QRgb colour, int tolerance = 6);

/// The most frequent colour within 4 pixels of @p position, which is not @p background; background if none.
[[nodiscard]] QRgb colourAt(const QImage& image, const QPointF& position, QRgb background);

inline constexpr QRgb FloorBlue = 0xFF4084E0, WallYellow = 0xFFE8C410, CeilingRed = 0xFFD64E4A;
inline constexpr QRgb DarkBackground = 0xFF12151A;

}  // namespace leitstand::test
