#include "widgets/map_view/overlays/floor/kept_picture.h"

#include <QPainter>

#include "widgets/map_view/overlays/overlay_style.h"

namespace leitstand {

void KeptPicture::paint(QPainter& painter, const MapProjection& projection, const OverlayStyle& style,
                        const std::function<void(QPainter&)>& make) {
    if (projection.size().isEmpty()) return;
    const double ratio = painter.device()->devicePixelRatioF();
    const bool same = m_picture.size() == projection.size() * ratio &&
                      qFuzzyCompare(m_picture.devicePixelRatio(), ratio) && m_camera == projection.camera() &&
                      m_colours == style.window;
    if (!same) {
        m_picture = QImage(projection.size() * ratio, QImage::Format_ARGB32_Premultiplied);
        m_picture.setDevicePixelRatio(ratio);
        m_picture.fill(Qt::transparent);
        m_camera = projection.camera();
        m_colours = style.window;
        ++m_made;
        QPainter making(&m_picture);
        make(making);
    }
    painter.drawImage(QPoint(0, 0), m_picture);
}

}  // namespace leitstand
