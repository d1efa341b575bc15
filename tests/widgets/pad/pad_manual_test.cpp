// The manual's table of the gamepad against the bindings that the program comes with.
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <QString>
#include <QStringList>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "widgets/models/pad/pad_texts.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

/// A row of the manual's table, in small letters and without stars.
struct ManualRow {
    std::vector<std::string> controls;  ///< "left trigger"
    std::string does;
};

std::vector<ManualRow> manualRows() {
    std::ifstream manual(sourceFolder() + "/docs/operator.md");
    std::vector<ManualRow> rows;
    bool inside = false;
    for (std::string line; std::getline(manual, line);) {
        if (line.rfind("## ", 0) == 0) inside = line == "## Gamepad";
        if (!inside || line.rfind("| ", 0) != 0) continue;
        const QString plain = QString::fromStdString(line).remove(QLatin1Char('*')).toLower();
        ManualRow row;
        for (const QString& one : plain.section(QLatin1Char('|'), 1, 1).replace(';', ',').split(','))
            row.controls.push_back(one.trimmed().toStdString());
        row.does = plain.section(QLatin1Char('|'), 2, 2).toStdString();
        rows.push_back(row);
    }
    return rows;
}

/// What the manual says of @p control; empty when it does not name it.
std::string eventsOf(const PadControl& control) {
    std::string name = padControlName(control, PadLayout::Standard).toLower().toStdString();
    if (control.kind == PadControl::Kind::Axis && name.find("stick") != std::string::npos)
        name = name.substr(0, name.rfind(' '));  // both ends are one row
    for (const ManualRow& row : manualRows()) {
        for (const std::string& one : row.controls) {
            if (one == name) return row.does;
        }
    }
    return {};
}

TEST(PadManual, TellsWhatEachControlOfANewPadDoes) {
    const std::map<PadAction, std::string> words = {{PadAction::DeadMan, "hold to drive"},
                                                    {PadAction::Forward, "forward"},
                                                    {PadAction::Back, "back"},
                                                    {PadAction::TurnLeft, "left"},
                                                    {PadAction::TurnRight, "right"},
                                                    {PadAction::Turbo, "turbo"},
                                                    {PadAction::Slow, "slow"},
                                                    {PadAction::Stop, "stops all robots"},
                                                    {PadAction::PanLeft, "cameras"},
                                                    {PadAction::PanRight, "cameras"},
                                                    {PadAction::TiltUp, "cameras"},
                                                    {PadAction::TiltDown, "cameras"},
                                                    {PadAction::WithoutEyes, "without eyes"}};
    const PadBindings bindings = defaultBindings(PadLayout::Standard);
    std::size_t reported = 0;
    for (const PadAction action : padActions()) {
        if (bindings.at(action).kind == PadControl::Kind::None) continue;
        ASSERT_TRUE(words.contains(action)) << toString(action) << " is new: add it to the manual and here";
        EXPECT_THAT(eventsOf(bindings.at(action)), HasSubstr(words.at(action))) << toString(action);
        ++reported;
    }
    EXPECT_EQ(reported, words.size());
}

TEST(PadManual, TellsTheCommandsThatANewPadGives) {
    const std::map<std::string, std::string> words = {
        {"robot.next", "next robot"},       {"camera.recentre", "re-centres the cameras"},
        {"pad.legend", "this table"},       {"victim.freeze", "files what the robot sees"},
        {"victim.confirm", "confirms"},     {"form.previous", "the previous field"},
        {"form.next", "goes to the next"},  {"form.change", "field's next choice"},
        {"joints.pad", "flippers and arm"}, {"joints.next", "the next of them"}};
    const PadBindings bindings = defaultBindings(PadLayout::Standard);
    for (const PadCommand& command : bindings.commands) {
        ASSERT_TRUE(words.contains(command.id)) << command.id << " is new: add it to the manual and here";
        EXPECT_THAT(eventsOf(command.control), HasSubstr(words.at(command.id))) << command.id;
    }
    EXPECT_EQ(bindings.commands.size(), words.size());
}

}  // namespace
}  // namespace leitstand::test
