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

/// The contents of a pane's header, along its upper edge.
struct PaneHead {
    RobotFace face;
    QString title;  ///< "Left camera"; shown after the robot's letter
    QString note;   ///< text after the age: "full speed"; may be empty
    DataAge age;
    FreshnessLimits limits = {};
    bool vacant = false;  ///< whether no data are expected; then neither age nor loss is shown
};

/// Returns the height of a pane's header in @p font [px].
[[nodiscard]] int paneHeadHeight(const QFont& font);
/// Paints the header on a translucent strip, so that it is legible over pictures, and a line in the robot's
/// colour along the pane's left edge. If there is little space, the title is elided, not the age.
void paintPaneHead(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);
/// Paints "no data for 4 s" or "no data yet" into the middle of @p pane. Paints nothing while the data are
/// live or stale, or when the pane is vacant.
void paintLoss(QPainter& painter, const QRect& pane, const PaneHead& head, const ThemeColours& colours);

[[nodiscard]] const QColor& toneColour(Tone tone, const ThemeColours& colours);
/// Returns a grey with the lightness of @p colour.
[[nodiscard]] QColor greyed(const QColor& colour);

/// Paints the background for @p mode in the mode's colour; ModeKind::Lost is also hatched. @p radius: radius
/// of the corners [px].
void paintModeSurface(QPainter& painter, const QRectF& box, ModeKind mode, const ThemeColours& colours,
                      double radius = 0.0);
/// Returns the colour of text on the background of @p mode.
[[nodiscard]] QColor modeInk(ModeKind mode, const ThemeColours& colours);

/// Returns @p font in the size @p pixels, bold or not.
[[nodiscard]] QFont sized(QFont font, int pixels, bool bold = false);
/// Returns @p font in the largest size, from @p pixels down to @p least, at which @p text is at most @p width
/// wide [px]. If none is small enough, the size is @p least.
[[nodiscard]] QFont fitted(const QFont& font, const QString& text, double width, int pixels, int least,
                           bool bold = true);

/// Paints @p text from the top of @p box, wrapped to at most @p lines lines. If the text is longer, the last
/// line is elided.
void paintWrapped(QPainter& painter, const QRectF& box, const QString& text, int lines);

}  // namespace leitstand
