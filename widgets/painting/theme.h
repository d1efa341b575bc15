#pragma once

#include <array>

#include <QColor>

#include "widgets/models/map/map_view_settings.h"

class QApplication;

namespace leitstand {

/// The colours of the window; their meaning is the same in every theme.
struct ThemeColours {
    QColor window, pane, strip;   ///< surfaces, from back to front
    QColor field, hover, chosen;  ///< inputs, what the pointer is on, what is selected
    QColor line, faint;           ///< separators between panes, between rows
    QColor text, muted;
    QColor select;  ///< selected or controllable
    QColor fine;
    QColor attention;  ///< look here
    QColor act;        ///< act now
    QColor stop;
    QColor wall;                                      ///< outer contour of the virtual scan
    QColor obstacle;                                  ///< its inner contour
    QColor laser;                                     ///< what a plane laser measured
    QColor teleoperation, autonomous, stopped, lost;  ///< backgrounds of modes; of a stop it is stop
    std::array<QColor, 8> robots;                     ///< edges of panes, by the robot's place in the team

    /// Of the @p place -th robot.
    [[nodiscard]] const QColor& robot(int place) const {
        return robots[static_cast<std::size_t>(place < 0 ? 0 : place) % robots.size()];
    }
};

/// The colours of @p theme.
[[nodiscard]] const ThemeColours& coloursOf(Theme theme);
/// The theme that the application has, for painters.
[[nodiscard]] Theme presentTheme();

/// Gives all of @p application the style, font and colours of @p theme. Painters find muted text in the
/// palette's PlaceholderText and attention in its BrightText.
void applyTheme(QApplication& application, Theme theme);

}  // namespace leitstand
