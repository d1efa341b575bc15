#include "core/io/pad/pad_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;
using Kind = PadControl::Kind;

constexpr std::array<std::string_view, 8> FileKeys = {"pad",   "layout",      "dead_zone", "expo",
                                                      "press", "camera_rate", "controls",  "commands"};
constexpr std::array<std::string_view, 4> ControlKeys = {"button", "axis", "towards", "rest"};
constexpr std::array<std::string_view, 5> CommandKeys = {"command", "button", "axis", "towards", "rest"};

const std::vector<std::pair<std::string, PadLayout>>& layoutWords() {
    static const std::vector<std::pair<std::string, PadLayout>> words = {{"standard", PadLayout::Standard},
                                                                         {"plain", PadLayout::Plain}};
    return words;
}

/// Reads {button: 3} or {axis: 1, towards: -1, rest: 0}.
PadControl readControl(const YamlFields& fields) {
    const bool button = fields.has("button"), axis = fields.has("axis");
    if (button == axis) {
        fields.fail(
            "button",
            button ? translate("leitstand::Error", "expected either a button or an axis, found both")
                   : translate("leitstand::Error", "expected either a button or an axis, found neither"));
        return {};
    }
    int index = 0, towards = 1;
    double rest = 0.0;
    const int most = PadBindings::MostControls - 1;
    if (button) return fields.count("button", index, 0, most) ? padButton(index) : PadControl{};
    bool right = fields.count("axis", index, 0, most);
    right = fields.count("towards", towards, -1, 1) && right;
    right = fields.number("rest", rest, -1.0, 1.0, "") && right;
    if (towards == 0 || static_cast<double>(towards) == rest) {
        right = fields.fail("towards",
                            translate("leitstand::Error",
                                      "expected -1 or 1, the end to which the axis is pushed from its rest"));
    }
    return right ? padAxis(index, towards, rest) : PadControl{};
}

void readControls(const YamlPlace& place, PadBindings& bindings, YamlErrors& errors) {
    std::vector<std::string> names;
    for (const PadAction action : padActions()) names.push_back(toString(action));
    const std::vector<std::string_view> keys(names.begin(), names.end());
    const YamlFields fields(place, keys, errors);
    for (const PadAction action : padActions()) {
        if (!fields.has(toString(action))) continue;
        bindings.at(action) = readControl(YamlFields(fields.at(toString(action)), ControlKeys, errors));
    }
}

/// Whether @p text looks like "camera.recentre" or "view.look-2".
bool isCommandId(std::string_view text) {
    return std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return c < 0x80 && (std::isalnum(c) != 0 || c == '.' || c == '_' || c == '-');
    });
}

void readCommands(const YamlFields& file, PadBindings& bindings, YamlErrors& errors) {
    const auto places = file.list("commands");
    if (places.size() > PadBindings::MostCommands) {
        file.fail("commands",
                  leitstand::fill(translate("leitstand::Error", "expected at most {} commands, found {}"),
                                  PadBindings::MostCommands, places.size()));
        return;
    }
    for (const YamlPlace& place : places) {
        const YamlFields fields(place, CommandKeys, errors);
        PadCommand command;
        if (!fields.has("command")) {
            fields.fail("command", translate("leitstand::Error",
                                             "expected the command that the control does, found nothing"));
            continue;
        }
        if (!fields.text("command", command.id)) continue;
        if (!isCommandId(command.id)) {
            fields.fail("command",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected a command such as camera.recentre, found {}"),
                                        detail::shown(std::string_view(command.id))));
            continue;
        }
        command.control = readControl(fields);
        bindings.commands.push_back(std::move(command));
    }
}

void writeControl(YAML::Emitter& out, const PadControl& control) {
    if (control.kind == Kind::Button) {
        out << YAML::Key << "button" << YAML::Value << control.index;
        return;
    }
    out << YAML::Key << "axis" << YAML::Value << control.index;
    out << YAML::Key << "towards" << YAML::Value << (control.negative ? -1 : 1);
    if (control.rest != 0.0) out << YAML::Key << "rest" << YAML::Value << fmt::format("{}", control.rest);
}

}  // namespace

Result<PadBindings> parsePad(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors(name);
    const YamlFields fields({*root, {}, 1}, FileKeys, errors);
    PadBindings bindings;
    std::string pad;
    fields.text("pad", pad, true);
    fields.choice("layout", bindings.layout, layoutWords());
    fields.number("dead_zone", bindings.deadZone, 0.0, PadBindings::MostDeadZone, "");
    fields.number("expo", bindings.expo, 0.0, 1.0, "");
    fields.number("press", bindings.press, PadBindings::LeastPress, PadBindings::MostPress, "");
    fields.number("camera_rate", bindings.cameraRate, 0.0, PadBindings::MostRate, " rad/s");
    if (fields.has("controls")) readControls(fields.at("controls"), bindings, errors);
    if (fields.has("commands")) readCommands(fields, bindings, errors);
    if (!errors.empty()) return errors.error();
    return bindings;
}

Result<PadBindings> readPad(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    // Reads one byte more than the limit, which shows that a file is too large without reading all of it.
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parsePad(text, file.string());
}

std::string padText(const PadBindings& bindings, const std::string& pad) {
    YAML::Emitter out;
    out << YAML::Comment("Controls of a gamepad of Leitstand; docs/operator.md tells what they do.");
    out << YAML::BeginMap << YAML::Key << "pad" << YAML::Value << YAML::DoubleQuoted << pad;
    for (const auto& [word, layout] : layoutWords()) {
        if (layout == bindings.layout) out << YAML::Key << "layout" << YAML::Value << word;
    }
    for (const auto& [key, value] :
         {std::pair("dead_zone", bindings.deadZone), std::pair("expo", bindings.expo),
          std::pair("press", bindings.press), std::pair("camera_rate", bindings.cameraRate)}) {
        out << YAML::Key << key << YAML::Value << fmt::format("{}", value);
    }
    out << YAML::Key << "controls" << YAML::Value << YAML::BeginMap;
    for (const PadAction action : padActions()) {
        if (bindings.at(action).kind == Kind::None) continue;
        out << YAML::Key << toString(action) << YAML::Value << YAML::Flow << YAML::BeginMap;
        writeControl(out, bindings.at(action));
        out << YAML::EndMap;
    }
    out << YAML::EndMap << YAML::Key << "commands" << YAML::Value << YAML::BeginSeq;
    for (const PadCommand& command : bindings.commands) {
        if (command.control.kind == Kind::None) continue;
        out << YAML::Flow << YAML::BeginMap << YAML::Key << "command" << YAML::Value << command.id;
        writeControl(out, command.control);
        out << YAML::EndMap;
    }
    out << YAML::EndSeq << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

Result<void> writePad(const PadBindings& bindings, const std::string& pad,
                      const std::filesystem::path& file) {
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    // The name of a pad may contain anything.
    std::string name;
    for (const char c : pad.substr(0, 64)) name += c >= 0x20 && c < 0x7F ? c : '?';
    return detail::writeWhole(file, padText(bindings, name));
}

}  // namespace leitstand
