#pragma once

#include <vector>

#include <QImage>
#include <QRectF>
#include <QString>
#include <QWidget>

#include "tests/widgets/live/sample_robot.h"
#include "widgets/models/live/robots/drive_state.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand::test {

/// Gives the test's application @p theme.
void useTheme(Theme theme);
/// @p widget as it looks in @p size; for people to look at also a file in the folder LEITSTAND_PICTURES.
[[nodiscard]] QImage pictureOf(QWidget& widget, const QSize& size, const QString& name, double scale = 1.0);
/// How many pixels of @p picture are @p colour, channels within @p tolerance.
[[nodiscard]] int countOf(const QImage& picture, const QColor& colour, int tolerance = 12);
/// How many pixels differ in their channels by more than @p least: are coloured.
[[nodiscard]] int colouredPixels(const QImage& picture, int least = 24);

/// A piece of text as a widget painted it.
struct PaintedText {
    QString text;
    QRectF box;  ///< in the widget [px]
};
/// All text that @p widget and its children paint.
[[nodiscard]] std::vector<PaintedText> paintedTexts(QWidget& widget);
/// What is wrong with the texts of @p widget: painted outside of it, over one another, or cut by dots.
[[nodiscard]] QStringList textFaults(QWidget& widget);

[[nodiscard]] DriveState driveStateOf(const SampleRobot& robot);

}  // namespace leitstand::test
