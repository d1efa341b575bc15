#pragma once

#include <functional>

#include <QImage>

#include "widgets/map_view/camera/map_camera.h"

class QPainter;

namespace leitstand {

struct OverlayStyle;
struct ThemeColours;

/// A picture over the map that is costly to paint. Keeps it until the camera moves or the theme changes,
/// since robots, trails and tools over it are painted far more often.
class KeptPicture {
public:
    void drop() { m_picture = {}; }  ///< the picture has to be made again
    /// Paints the picture. Calls @p make, which paints in the widget's coordinates and without antialiasing,
    /// when there is none for @p projection and @p style.
    void paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style,
               const std::function<void(QPainter&)>& make);
    /// Number of times that the picture was made; for tests.
    [[nodiscard]] int made() const { return m_made; }

private:
    QImage m_picture;  ///< null: it must be made
    MapCamera m_camera;
    const ThemeColours* m_colours = nullptr;  ///< colours of m_picture's theme
    int m_made = 0;
};

}  // namespace leitstand
