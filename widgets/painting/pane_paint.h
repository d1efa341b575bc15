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
    bool vacant = false;  ///< no data are expected: neither age nor loss is shown
};

/// Returns the height of a pane's head in @p font [px].
[[nodiscard]] int paneHeadHeight(const QFont& font);
/// Paints the head on a translucent strip, legible over pictures, and a line in the robot's colour along the
/// pane's left edge. When there is little room, the title is elided, not the age.
void paintPaneHead(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);
/// Paints "no data for 4 s" or "no data yet" into the middle of @p pane. Paints nothing while the data are
/// live or stale, or when the pane is vacant.
void paintLoss(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);

[[nodiscard]] const QColor& toneColour(Tone tone, const ThemeColours& colours);
/// Returns a grey as light as @p colour.
[[nodiscard]] QColor greyed(const QColor& colour);

/// Paints the background for @p mode in the colour of the mode; ModeKind::Lost is hatched, too. @p radius: of
/// the corners [px].
void paintModeSurface(QPainter& painter, const QRectF& box, ModeKind mode, const ThemeColours& colours,
                      double radius = 0.0);
/// Returns the colour of text on the background of @p mode.
[[nodiscard]] QColor modeInk(ModeKind mode, const ThemeColours& colours);

/// Returns @p font at @p pixels, bold or not.
[[nodiscard]] QFont sized(QFont font, int pixels, bool bold = false);
/// Returns @p font in the largest size, from @p pixels down to @p least, in which @p text is at most @p width
/// wide [px]. If none is small enough: in size @p least.
[[nodiscard]] QFont fitted(const QFont& font, const QString& text, double width, int pixels, int least,
                           bool bold = true);

/// Paints @p text from the top of @p box, wrapped into at most @p lines lines. If the text is longer, the
/// last line is elided.
void paintWrapped(QPainter& painter, const QRectF& box, const QString& text, int lines);

}  // namespace leitstand
