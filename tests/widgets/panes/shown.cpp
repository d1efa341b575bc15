#include "tests/widgets/panes/shown.h"

#include <algorithm>
#include <cstdlib>

#include <QApplication>
#include <QDir>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>

#include "widgets/painting/theme.h"

namespace leitstand::test {
namespace {

/// Keeps the texts that are painted and forgets all else.
class TextEngine final : public QPaintEngine {
public:
    TextEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice* /*device*/) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& /*state*/) override {}
    void drawPixmap(const QRectF& /*to*/, const QPixmap& /*pixmap*/, const QRectF& /*from*/) override {}
    void drawPath(const QPainterPath& /*path*/) override {}
    void drawPolygon(const QPointF* /*points*/, int /*count*/, PolygonDrawMode /*mode*/) override {}
    void drawTextItem(const QPointF& at, const QTextItem& item) override {
        const QRectF box(at.x(), at.y() - item.ascent(), item.width(), item.ascent() + item.descent());
        texts.push_back({item.text(), painter()->deviceTransform().mapRect(box)});
    }
    [[nodiscard]] Type type() const override { return User; }

    std::vector<PaintedText> texts;
};

class TextDevice final : public QPaintDevice {
public:
    explicit TextDevice(const QSize& size) : m_size(size) {}
    [[nodiscard]] QPaintEngine* paintEngine() const override { return &m_engine; }
    [[nodiscard]] std::vector<PaintedText> texts() const { return m_engine.texts; }

protected:
    [[nodiscard]] int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
            case PdmWidth:
                return m_size.width();
            case PdmHeight:
                return m_size.height();
            case PdmDepth:
                return 32;
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return 96;
            case PdmDevicePixelRatio:
                return 1;
            default:
                return QPaintDevice::metric(metric);
        }
    }

private:
    QSize m_size;
    mutable TextEngine m_engine;
};

}  // namespace

void useTheme(Theme theme) {
    applyTheme(*qobject_cast<QApplication*>(QCoreApplication::instance()), theme);
}

QImage pictureOf(QWidget& widget, const QSize& size, const QString& name, double scale) {
    widget.resize(size);
    widget.ensurePolished();
    QImage picture((QSizeF(size) * scale).toSize(), QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    picture.fill(coloursOf(presentTheme()).window);
    widget.render(&picture);
    const QString folder = qEnvironmentVariable("LEITSTAND_PICTURES");
    if (!folder.isEmpty() && !name.isEmpty()) {
        const QString theme =
            presentTheme() == Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light");
        picture.save(QDir(folder).filePath(QStringLiteral("%1-%2.png").arg(name, theme)));
    }
    return picture;
}

int countOf(const QImage& picture, const QColor& colour, int tolerance) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            const int off =
                std::max({std::abs(qRed(pixel) - colour.red()), std::abs(qGreen(pixel) - colour.green()),
                          std::abs(qBlue(pixel) - colour.blue())});
            count += off <= tolerance ? 1 : 0;
        }
    }
    return count;
}

int colouredPixels(const QImage& picture, int least) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb pixel = picture.pixel(x, y);
            const auto [low, high] = std::minmax({qRed(pixel), qGreen(pixel), qBlue(pixel)});
            count += high - low > least ? 1 : 0;
        }
    }
    return count;
}

std::vector<PaintedText> paintedTexts(QWidget& widget) {
    TextDevice device(widget.size());
    widget.render(&device);
    std::vector<PaintedText> texts = device.texts();
    std::erase_if(texts, [](const PaintedText& one) { return one.text.trimmed().isEmpty(); });
    return texts;
}

QStringList textFaults(QWidget& widget) {
    QStringList faults;
    const std::vector<PaintedText> texts = paintedTexts(widget);
    const QRectF inside = QRectF(widget.rect()).adjusted(-0.5, -0.5, 0.5, 0.5);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const PaintedText& one = texts[i];
        if (!inside.contains(one.box)) faults << QStringLiteral("\"%1\" leaves the widget").arg(one.text);
        if (one.text.contains(QChar(0x2026))) faults << QStringLiteral("\"%1\" is cut").arg(one.text);
        for (std::size_t j = 0; j < i; ++j) {
            // Lines may touch; rims are the same text again.
            const QRectF core = one.box.adjusted(1, 3, -1, -3);
            if (one.text != texts[j].text && core.intersects(texts[j].box.adjusted(1, 3, -1, -3)))
                faults << QStringLiteral("\"%1\" over \"%2\"").arg(one.text, texts[j].text);
        }
    }
    faults.removeDuplicates();
    return faults;
}

DriveState driveStateOf(const SampleRobot& robot) {
    return leitstand::driveStateOf(robot.face, robot.description, robot.view, robot.reported, robot.gas,
                                   at(0));
}

}  // namespace leitstand::test
