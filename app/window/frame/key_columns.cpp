#include "app/window/frame/key_columns.h"

namespace leitstand {
namespace {

void addMap(std::vector<KeyLine>& lines) {
    lines.push_back(
        {KeyColumns::tr("Left button"), KeyColumns::tr("turns the map; while measuring, picks a point")});
    lines.push_back({KeyColumns::tr("Middle, Shift+left"), KeyColumns::tr("shifts the map")});
    lines.push_back({KeyColumns::tr("Wheel, right button"), KeyColumns::tr("zooms the map")});
    lines.push_back(
        {KeyColumns::tr("Arrows, +, −"),
         KeyColumns::tr("in the map that has the keyboard: turn and zoom; with Shift they shift")});
    lines.push_back({KeyColumns::tr("+, −"), KeyColumns::tr("zoom the virtual scan that has the keyboard")});
}

void addFields(std::vector<KeyLine>& lines) {
    lines.push_back({KeyColumns::tr("Ctrl+C"), KeyColumns::tr("copies the chosen message")});
    lines.push_back({KeyColumns::tr("Tab, Shift+Tab"), KeyColumns::tr("next and previous field")});
}

}  // namespace

KeyColumn KeyColumns::live() {
    std::vector<KeyLine> lines = {
        {tr("Esc"), tr("stops all robots, always and everywhere")},
        {tr("Space or Return, held"), tr("on the handle beside STOP: releases the robot")},
        {tr("Click into the camera"), tr("drives with keys, as F2")},
        {tr("W S A D, arrows"), tr("drive, while driving with keys; a robot's file may bind others")},
        {tr("Shift, Ctrl"), tr("while driving: a quarter of the robot's speed, all of it")},
        {tr("Space"), tr("while driving: halts the robot")},
        {tr("G, held"), tr("while driving: drives without eyes")},
        {tr("Q E, Page Up, Page Down"), tr("turn the large camera while they are held, with Shift slowly")},
        {tr("Number pad 4 6 8 2, 5"), tr("turn the large camera; all cameras look ahead")},
        {tr("Dragging the large picture"), tr("turns its camera")},
        {tr("Shift+click"), tr("into a picture or the virtual scan: files the victim that is there")},
        {tr("Double click on the floor"), tr("sends the selected robot there, if it takes goals")},
        {tr("Right button"), tr("while something is placed on the map: ends that, takes a corner back")},
        {tr("Return"),
         tr("in a list: acknowledges the alarm, fills in the find's form, shows what was missed")},
    };
    addMap(lines);
    addFields(lines);
    return {tr("Besides the commands"), lines};
}

KeyColumn KeyColumns::review() {
    std::vector<KeyLine> lines = {
        {tr("← →"), tr("in the timeline: a second back, on; with Shift ten")},
        {tr("Home, End"), tr("in the timeline: to the start, to the end")},
        {tr("Return"), tr("in the list of finds: goes to when the chosen one was found")},
        {tr("Esc"), tr("ends measuring")},
    };
    addMap(lines);
    addFields(lines);
    return {tr("Besides the commands"), lines};
}

KeyColumn KeyColumns::mapByHand() {
    std::vector<KeyLine> lines = {
        {tr("Right button"), tr("while something is placed on the map: ends that, takes a corner back")},
        {tr("Esc"), tr("ends measuring")},
    };
    addMap(lines);
    addFields(lines);
    return {tr("Besides the commands"), lines};
}

}  // namespace leitstand
