#include "core/io/settings/layout_file.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

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

constexpr std::string_view LayoutKeys[] = {"title", "panes", "arrangement", "map", "keys", "pad"};
constexpr std::string_view SplitKeys[] = {"pane", "share", "horizontal", "vertical"};
constexpr std::string_view MapKeys[] = {"look", "follow"};
constexpr double LeastShare = 0.01, MostShare = 100.0;
constexpr std::size_t MostParts = 16, LongestText = 128, LongestArrangement = 64U << 10U;

template <class T>
using Words = std::vector<std::pair<std::string, T>>;

const Words<MapLook>& lookWords() {
    static const Words<MapLook> words = {
        {"points", MapLook::Points}, {"voxels", MapLook::Voxels}, {"top", MapLook::Top}};
    return words;
}

const Words<MapFollow>& followWords() {
    static const Words<MapFollow> words = {
        {"free", MapFollow::Free}, {"behind", MapFollow::Behind}, {"heading-up", MapFollow::Above}};
    return words;
}

bool isId(std::string_view text) {
    return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '.' || c == '-';
    });
}

void readSplit(const YamlPlace& place, PaneSplit& split, std::set<std::string>& seen, YamlErrors& errors) {
    const YamlFields fields(place, SplitKeys, errors);
    fields.number("share", split.share, LeastShare, MostShare, "");
    const int kinds = fields.has("pane") + fields.has("horizontal") + fields.has("vertical");
    if (kinds != 1) {
        errors.add(place.line, place.path,
                   translate("leitstand::Error", "expected one of pane, horizontal and vertical"));
        return;
    }
    if (fields.has("pane")) {
        if (!fields.text("pane", split.pane)) return;
        if (!isId(split.pane))
            fields.fail("pane", translate("leitstand::Error", "expected letters, digits, _ . and -"));
        if (!seen.insert(split.pane).second)
            fields.fail("pane", translate("leitstand::Error", "stands in this layout already"));
        return;
    }
    split.vertical = fields.has("vertical");
    const std::string_view key = split.vertical ? "vertical" : "horizontal";
    const auto parts = fields.list(key);
    if (parts.size() < 2 || parts.size() > MostParts) {
        fields.fail(key, leitstand::fill(translate("leitstand::Error", "expected a list of 2 to {} places"),
                                         MostParts));
        return;
    }
    for (const YamlPlace& part : parts) readSplit(part, split.parts.emplace_back(), seen, errors);
}

/// Reads a map of ids (commands, buttons) to texts.
void readWords(const YamlFields& fields, std::string_view key, std::map<std::string, std::string>& words,
               YamlErrors& errors) {
    if (!fields.has(key)) return;
    const YamlPlace place = fields.at(key);
    if (!place.value.IsMap()) {
        fields.fail(key, translate("leitstand::Error", "expected keys and values"));
        return;
    }
    for (const auto& entry : place.value) {
        const int line = detail::lineOf(entry.first);
        const bool plain = entry.first.IsScalar() && (entry.second.IsScalar() || entry.second.IsNull());
        const std::string word = plain ? entry.first.Scalar() : std::string();
        if (!plain || !isId(word)) {
            errors.add(line, place.path,
                       translate("leitstand::Error", "expected a command or button and its text"));
            continue;
        }
        const std::string text = entry.second.IsNull() ? std::string() : entry.second.Scalar();
        if (text.size() > LongestText || !words.emplace(word, text).second)
            errors.add(line, place.path + "." + word,
                       translate("leitstand::Error", "is too long, or stands here twice"));
    }
}

template <class T>
void readWord(const YamlFields& fields, std::string_view key, const Words<T>& words,
              std::optional<T>& value) {
    T found = words.front().second;
    if (fields.has(key) && fields.choice(key, found, words)) value = found;
}

void readMap(const YamlPlace& place, LayoutMap& map, YamlErrors& errors) {
    const YamlFields fields(place, MapKeys, errors);
    readWord(fields, "look", lookWords(), map.look);
    readWord(fields, "follow", followWords(), map.follow);
}

void emitSplit(YAML::Emitter& out, const PaneSplit& split) {
    if (!split.pane.empty()) out << YAML::Flow;
    out << YAML::BeginMap;
    if (split.pane.empty()) {
        out << YAML::Key << (split.vertical ? "vertical" : "horizontal") << YAML::Value << YAML::BeginSeq;
        for (const PaneSplit& part : split.parts) emitSplit(out, part);
        out << YAML::EndSeq;
    } else {
        out << YAML::Key << "pane" << YAML::Value << split.pane;
    }
    if (split.share != 1.0) out << YAML::Key << "share" << YAML::Value << split.share;
    out << YAML::EndMap;
}

template <class T>
void emitWord(YAML::Emitter& out, const char* key, const Words<T>& words, const std::optional<T>& value) {
    for (const auto& [word, means] : words) {
        if (means == value) out << YAML::Key << key << YAML::Value << word;
    }
}

void emitMap(YAML::Emitter& out, const LayoutMap& map) {
    if (!map.isMeaningful()) return;
    out << YAML::Key << "map" << YAML::Value << YAML::Flow << YAML::BeginMap;
    emitWord(out, "look", lookWords(), map.look);
    emitWord(out, "follow", followWords(), map.follow);
    out << YAML::EndMap;
}

void emitWords(YAML::Emitter& out, const char* key, const std::map<std::string, std::string>& words) {
    if (words.empty()) return;
    out << YAML::Key << key << YAML::Value << YAML::BeginMap;
    for (const auto& [word, text] : words)
        out << YAML::Key << word << YAML::Value << YAML::DoubleQuoted << text;
    out << YAML::EndMap;
}

}  // namespace

Result<WindowLayout> parseLayout(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors(name);
    WindowLayout layout;
    layout.name = std::filesystem::path(name).stem().string();
    {
        const YamlFields fields({*root, "", 1}, LayoutKeys, errors);
        layout.title = layout.name;
        fields.text("title", layout.title);
        std::set<std::string> seen;
        if (fields.has("panes")) {
            readSplit(fields.at("panes"), layout.panes, seen, errors);
        } else {
            errors.add(1, "panes",
                       translate("leitstand::Error", "expected the places of panes, found nothing"));
        }
        if (fields.has("arrangement")) {
            const YAML::Node node = fields.at("arrangement").value;
            const bool fits = node.IsScalar() && node.Scalar().size() <= LongestArrangement;
            if (fits) layout.arrangement = node.Scalar();
            if (!fits)
                fields.fail("arrangement",
                            translate("leitstand::Error", "expected what the window wrote here"));
        }
        if (fields.has("map")) readMap(fields.at("map"), layout.map, errors);
        readWords(fields, "keys", layout.keys, errors);
        readWords(fields, "pad", layout.pad, errors);
    }
    if (!errors.empty()) return errors.error();
    return layout;
}

Result<WindowLayout> readLayout(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseLayout(text, file.string());
}

std::string writeLayout(const WindowLayout& layout) {
    YAML::Emitter out;
    out << YAML::BeginMap << YAML::Key << "title" << YAML::Value << YAML::DoubleQuoted << layout.title;
    out << YAML::Key << "panes" << YAML::Value;
    emitSplit(out, layout.panes);
    if (!layout.arrangement.empty()) out << YAML::Key << "arrangement" << YAML::Value << layout.arrangement;
    emitMap(out, layout.map);
    emitWords(out, "keys", layout.keys);
    emitWords(out, "pad", layout.pad);
    out << YAML::EndMap << YAML::Newline;
    return out.c_str();
}

Result<void> saveLayout(const WindowLayout& layout, const std::filesystem::path& file) {
    return detail::writeWhole(file, writeLayout(layout));
}

}  // namespace leitstand
