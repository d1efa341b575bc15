#pragma once

#include <array>

#include <QColor>

#include "widgets/models/map/map_view_settings.h"

class QApplication;

namespace leitstand {

/// The colours of the window. Their meaning is the same in every theme.
struct ThemeColours {
    QColor window, pane, strip;   ///< surfaces, from back to front
    QColor field, hover, chosen;  ///< inputs, hovered items, selected items
    QColor line, faint;           ///< separators between panes, between rows
    QColor text, muted;
    QColor select;  ///< selected or controllable
    QColor fine;
    QColor attention;  ///< the operator should look here
    QColor act;        ///< the operator must act now
    QColor stop;
    QColor wall;                                      ///< outer contour of the virtual scan
    QColor obstacle;                                  ///< inner contour of the virtual scan
    QColor laser;                                     ///< points of a planar laser scanner
    QColor teleoperation, autonomous, stopped, lost;  ///< backgrounds of modes; a stop has the colour stop
    std::array<QColor, 8> robots;                     ///< edges of panes, by the robot's place in the team

    /// Returns the colour of the robot at @p place in the team (from 0). Colours repeat after eight robots.
    [[nodiscard]] const QColor& robot(int place) const {
        return robots[static_cast<std::size_t>(place < 0 ? 0 : place) % robots.size()];
    }
};

/// Returns the colours of @p theme.
[[nodiscard]] const ThemeColours& coloursOf(Theme theme);
/// Returns the application's present theme, for painters.
[[nodiscard]] Theme presentTheme();

/// Sets style, font and colours of @p theme for @p application. In the palette, PlaceholderText is the colour
/// of muted text, and BrightText is the colour of attention.
void applyTheme(QApplication& application, Theme theme);

}  // namespace leitstand
