#pragma once

#include <chrono>
#include <vector>

#include <QString>

#include "core/mission/timeline/timeline_marks.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/timeline/timeline_axis.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// The shapes of marks on a timeline, one for each kind of mark.
enum class MarkShape {
    Disc,      ///< victim
    Drop,      ///< candidate
    Triangle,  ///< alarm
    Square,    ///< note
    Diamond,   ///< decision
    Arrow,     ///< a find moved
    Bar,       ///< mode
    Cross,     ///< bump
    Ring,      ///< sighting
    Flag,      ///< session
};

/// A mark as it is drawn, with its text.
struct TimelineGlyph {
    TimelineMark mark;
    double place = 0.0;  ///< place on the axis, 0 to 1
    MarkShape shape = MarkShape::Square;
    Tone tone = Tone::Normal;
    QString letter;   ///< text within the shape: "1" of V1; may be empty
    QString details;  ///< "12:04:31 · K · alarm: link lost, silent for 4 s"
};

/// Returns the glyphs of @p marks on @p axis, by time. @p faces: faces of the robots.
[[nodiscard]] std::vector<TimelineGlyph> glyphsOf(const std::vector<TimelineMark>& marks,
                                                  const TimelineAxis& axis,
                                                  const std::vector<RobotFace>& faces);
/// Returns the text of a mark, without its time: "K · victim V1: confirmed".
[[nodiscard]] QString markText(const TimelineMark& mark, const std::vector<RobotFace>& faces);

/// Recorded time as text: "4:31.5", "1:04:31.5".
[[nodiscard]] QString recordedText(std::chrono::nanoseconds time);
/// Rate as text: "4×", "0.5×", "backwards 2×", "stands".
[[nodiscard]] QString rateText(double rate);
/// Returns the next of the rates 0.1 0.25 0.5 1 2 4 8 16 32, faster or slower, in the same direction. A rate
/// of 0 is treated as 1.
[[nodiscard]] double nextRate(double rate, bool faster);

}  // namespace leitstand
