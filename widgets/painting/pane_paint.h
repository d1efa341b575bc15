#pragma once

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>

#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/tone.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// What stands along the upper edge of a pane.
struct PaneHead {
    RobotFace face;
    QString title;  ///< "Left camera"; the robot's letter is put before it
    QString note;   ///< after the age: "full speed"; may be empty
    DataAge age;
    FreshnessLimits limits = {};
    bool vacant = false;  ///< nothing is expected here: no age, and no loss
};

/// Height of a pane's head in @p font [px].
[[nodiscard]] int paneHeadHeight(const QFont& font);
/// Paints the head, on a veil that keeps it legible over pictures, and the edge in the robot's colour. The
/// title gives way to the age.
void paintPaneHead(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);
/// Paints "no data for 4 s" across @p pane, when that is so.
void paintLoss(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);

[[nodiscard]] const QColor& toneColour(Tone tone, const ThemeColours& colours);
/// A grey as light as @p colour.
[[nodiscard]] QColor greyed(const QColor& colour);

/// The surface of a mode: its colour, hatched where the mode is not known any more.
void paintModeSurface(QPainter& painter, const QRectF& box, ModeKind mode, const ThemeColours& colours,
                      double radius = 0.0);
/// What is written on it.
[[nodiscard]] QColor modeInk(ModeKind mode, const ThemeColours& colours);

/// @p font in @p pixels, bold or not, its digits all of one width where the font can.
[[nodiscard]] QFont sized(QFont font, int pixels, bool bold = false);
/// The largest of @p pixels down to @p least in which @p text is at most @p width wide.
[[nodiscard]] QFont fitted(const QFont& font, const QString& text, double width, int pixels, int least,
                           bool bold = true);

/// Paints @p text into at most @p lines lines; what has no room ends in dots.
void paintWrapped(QPainter& painter, const QRectF& box, const QString& text, int lines);

}  // namespace leitstand
