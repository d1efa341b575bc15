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

/// The contents of a pane's head, along its upper edge.
struct PaneHead {
    RobotFace face;
    QString title;  ///< "Left camera"; shown after the robot's letter
    QString note;   ///< after the age: "full speed"; may be empty
    DataAge age;
    FreshnessLimits limits = {};
    bool vacant = false;  ///< nothing is expected here: no age, and no loss
};

/// Returns the height of a pane's head in @p font [px].
[[nodiscard]] int paneHeadHeight(const QFont& font);
/// Paints the head, on a veil that keeps it legible over pictures, and the edge in the robot's colour. The
/// title is elided before the age.
void paintPaneHead(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);
/// Paints "no data for 4 s" across @p pane, if its data is lost.
void paintLoss(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);

[[nodiscard]] const QColor& toneColour(Tone tone, const ThemeColours& colours);
/// Returns a grey as light as @p colour.
[[nodiscard]] QColor greyed(const QColor& colour);

/// Paints the surface of a mode: its colour, hatched when the mode is no longer known.
void paintModeSurface(QPainter& painter, const QRectF& box, ModeKind mode, const ThemeColours& colours,
                      double radius = 0.0);
/// Returns the colour of text on that surface.
[[nodiscard]] QColor modeInk(ModeKind mode, const ThemeColours& colours);

/// Returns @p font at @p pixels, bold or not.
[[nodiscard]] QFont sized(QFont font, int pixels, bool bold = false);
/// Returns the largest font from @p pixels down to @p least in which @p text is at most @p width wide; else
/// @p least.
[[nodiscard]] QFont fitted(const QFont& font, const QString& text, double width, int pixels, int least,
                           bool bold = true);

/// Paints @p text into at most @p lines lines; the last one is elided.
void paintWrapped(QPainter& painter, const QRectF& box, const QString& text, int lines);

}  // namespace leitstand
