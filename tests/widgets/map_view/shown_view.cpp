#include "tests/widgets/map_view/shown_view.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <QTest>
#include <QWheelEvent>

namespace leitstand::test {
namespace {

constexpr int Patience = 10'000;   ///< [ms]
constexpr int OverlayHeight = 44;  ///< legend and scale bar [px]

bool alike(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) <= tolerance && std::abs(qGreen(a) - qGreen(b)) <= tolerance &&
           std::abs(qBlue(a) - qBlue(b)) <= tolerance;
}

}  // namespace

MapViewSettings settingsOf(MapLook look, MapColouring colouring, Theme theme) {
    MapViewSettings settings;
    settings.look = look;
    settings.colouring = colouring;
    settings.theme = theme;
    return settings;
}

MapViewSettings voxelsOf(double size) {
    MapViewSettings settings = settingsOf(MapLook::Voxels);
    settings.voxelSize = size;
    return settings;
}

bool waitFor(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, Patience);
}

ShownView::ShownView(MapPtr map, const MapViewSettings& settings, QSize size) {
    m_view.resize(size);
    m_view.setSettings(settings);
    m_view.setMap(std::move(map));
    m_view.show();
    settle();
}

void ShownView::set(const MapViewSettings& settings) {
    m_view.setSettings(settings);
    settle();
}

void ShownView::alter(const std::function<void(MapViewSettings&)>& change) {
    MapViewSettings settings = m_view.settings();
    change(settings);
    set(settings);
}

bool ShownView::settle() {
    const bool settled = waitFor([this] { return m_view.settled(); });
    EXPECT_TRUE(settled) << "the picture is never complete";
    return settled;
}

void ShownView::drag(Qt::MouseButton button, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers) {
    constexpr int Steps = 8;
    QTest::mousePress(&m_view, button, modifiers, from);
    for (int i = 1; i <= Steps; ++i) {
        const QPointF place = QPointF(from) + QPointF(to - from) * i / Steps;
        QMouseEvent move(QEvent::MouseMove, place, m_view.mapToGlobal(place), Qt::NoButton, button,
                         modifiers);
        QCoreApplication::sendEvent(&m_view, &move);
    }
    QTest::mouseRelease(&m_view, button, modifiers, to);
    settle();
}

void ShownView::wheel(QPoint position, int notches) {
    QWheelEvent event(position, m_view.mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&m_view, &event);
    settle();
}

void ShownView::click(QPoint position) {
    QTest::mouseClick(&m_view, Qt::LeftButton, {}, position);
}

void ShownView::hover(QPoint position) {
    // Not QTest::mouseMove(): it sends nothing when the pointer is there already.
    QMouseEvent move(QEvent::MouseMove, position, m_view.mapToGlobal(position), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&m_view, &move);
}

void ShownView::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&m_view, key, modifiers);
    settle();
}

QPointF ShownView::at(const Eigen::Vector3d& pointInMap) {
    const auto place = m_view.project(pointInMap);
    EXPECT_TRUE(place) << "behind the camera";
    return place.value_or(QPointF());
}

int countPixels(const QImage& image, QRgb colour, int tolerance) {
    int count = 0;
    const int bottom = image.height() - int(std::lround(OverlayHeight * image.devicePixelRatio()));
    for (int y = 0; y < bottom; ++y) {
        for (int x = 0; x < image.width(); ++x) count += alike(image.pixel(x, y), colour, tolerance) ? 1 : 0;
    }
    return count;
}

QRgb colourAt(const QImage& image, const QPointF& position, QRgb background) {
    constexpr int Reach = 4;
    const QPoint middle = (position * image.devicePixelRatio()).toPoint();
    std::map<QRgb, int> counts;
    for (int y = -Reach; y <= Reach; ++y) {
        for (int x = -Reach; x <= Reach; ++x) {
            const QPoint place = middle + QPoint(x, y);
            if (image.valid(place) && image.pixel(place) != background) ++counts[image.pixel(place)];
        }
    }
    QRgb best = background;
    int most = 0;
    for (const auto& [colour, count] : counts) {
        if (count > most) {
            most = count;
            best = colour;
        }
    }
    return best;
}

}  // namespace leitstand::test
