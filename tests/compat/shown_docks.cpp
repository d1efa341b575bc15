#include "tests/compat/shown_docks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>

#include <QDockWidget>
#include <QMainWindow>
#include <QStringList>

namespace leitstand::test {
namespace {

/// How far a pane may lie off, since fonts of another system make panes need more: thousandths or pixels.
constexpr int Tolerance = 30;

struct DockLine {
    std::string name, area, state, with;
    std::array<int, 4> place{};
};

DockLine parsed(const std::string& text) {
    DockLine line;
    std::istringstream in(text);
    in >> line.name >> line.area >> line.state;
    for (int& number : line.place) in >> number;
    std::getline(in >> std::ws, line.with);
    return line;
}

std::string text(const DockLine& line) {
    std::ostringstream out;
    out << line.name << ' ' << line.area << ' ' << line.state;
    for (const int number : line.place) out << ' ' << number;
    if (!line.with.empty()) out << ' ' << line.with;
    return out.str();
}

std::string nameOf(Qt::DockWidgetArea area) {
    switch (area) {
        case Qt::LeftDockWidgetArea:
            return "left";
        case Qt::RightDockWidgetArea:
            return "right";
        case Qt::TopDockWidgetArea:
            return "top";
        case Qt::BottomDockWidgetArea:
            return "bottom";
        default:
            return "nowhere";
    }
}

std::string stateOf(const QDockWidget& dock) {
    if (dock.isHidden()) return "hidden";
    if (dock.isFloating()) return "floating";
    return dock.visibleRegion().isEmpty() ? "behind" : "front";
}

DockLine lineOf(const QMainWindow& window, QDockWidget& dock) {
    DockLine line;
    line.name = dock.objectName().toStdString();
    line.area = nameOf(window.dockWidgetArea(&dock));
    line.state = stateOf(dock);
    const QRect place = dock.geometry();
    if (line.state == "floating") line.place = {place.x(), place.y(), place.width(), place.height()};
    if (line.state == "front") {
        const double wide = 1e-3 * window.width(), high = 1e-3 * window.height();
        line.place = {static_cast<int>(std::lround(place.x() / wide)),
                      static_cast<int>(std::lround(place.y() / high)),
                      static_cast<int>(std::lround(place.width() / wide)),
                      static_cast<int>(std::lround(place.height() / high))};
    }
    QStringList others;
    for (const QDockWidget* other : window.tabifiedDockWidgets(&dock)) others += other->objectName();
    others.sort();
    if (!others.isEmpty()) line.with = "with " + others.join(u',').toStdString();
    return line;
}

/// The names after "with", in the order in which shownDocks() has them.
std::string renamedIn(const std::string& with, const std::map<std::string, std::string>& renamed) {
    if (with.empty()) return with;
    QStringList names = QString::fromStdString(with.substr(5)).split(u',');
    for (QString& name : names) {
        const auto found = renamed.find(name.toStdString());
        if (found != renamed.end()) name = QString::fromStdString(found->second);
    }
    names.sort();
    return "with " + names.join(u',').toStdString();
}

bool isSame(const DockLine& expected, const DockLine& found) {
    return expected.area == found.area && expected.state == found.state && expected.with == found.with &&
           std::equal(expected.place.begin(), expected.place.end(), found.place.begin(),
                      [](int one, int other) { return std::abs(one - other) <= Tolerance; });
}

}  // namespace

std::vector<std::string> shownDocks(const QMainWindow& window) {
    std::vector<std::string> lines;
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        if (dock->parentWidget() == &window) lines.push_back(text(lineOf(window, *dock)));
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

std::vector<std::string> dockDifferences(const std::vector<std::string>& expected,
                                         const std::vector<std::string>& found,
                                         const std::vector<std::string>& renamed) {
    std::map<std::string, std::string> names;
    for (const std::string& line : renamed) {
        const auto space = line.find(' ');
        names[line.substr(0, space)] = line.substr(space + 1);
    }
    std::map<std::string, DockLine> shown;
    for (const std::string& line : found) shown[parsed(line).name] = parsed(line);
    std::vector<std::string> differences;
    for (const std::string& line : expected) {
        DockLine wanted = parsed(line);
        const std::string before = wanted.name;
        if (const auto now = names.find(wanted.name); now != names.end()) wanted.name = now->second;
        wanted.with = renamedIn(wanted.with, names);
        const auto dock = shown.find(wanted.name);
        if (dock == shown.end()) {
            differences.push_back(before + ": there is no dock of this name any more");
        } else if (!isSame(wanted, dock->second)) {
            differences.push_back(before + ": expected \"" + text(wanted) + "\", found \"" +
                                  text(dock->second) + "\"");
        }
    }
    return differences;
}

}  // namespace leitstand::test
