#include "robots/simulation/arena/element_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "robots/simulation/arena/mesh/qr_code.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"

namespace leitstand::simulation {
namespace {

using detail::YamlErrors;
using detail::YamlFields;

constexpr double SmallestSize = 0.001;  ///< [m]
constexpr int MostCells = 100;          ///< of a step field, along each edge

template <class T>
std::vector<std::pair<std::string, T>> choicesOf(int count) {
    std::vector<std::pair<std::string, T>> choices;
    for (int i = 0; i < count; ++i) choices.emplace_back(toString(static_cast<T>(i)), static_cast<T>(i));
    return choices;
}

void readSize(const YamlFields& fields, Eigen::Vector3d& size) {
    const std::vector<double> found = fields.numbers("size", 3, LargestGround);
    if (found.empty()) return;
    if (*std::min_element(found.begin(), found.end()) < SmallestSize) {
        return fields.fail(
            "size", fmt::format("expected three numbers from {} to {} [m]", SmallestSize, LargestGround));
    }
    size = {found[0], found[1], found[2]};
}

void readHeights(const YamlFields& fields, Element& element) {
    const double columns = std::round(element.size.x() / element.cell);
    const double rows = std::round(element.size.y() / element.cell);
    if (columns < 1 || rows < 1 || columns > MostCells || rows > MostCells) {
        return fields.fail("cell",
                           fmt::format("expected 1 to {} cells along each edge of the size", MostCells));
    }
    bool right = true;
    fields.each("heights", false, [&](const YAML::Node& node, const std::string&, const std::string&) {
        double height = -1.0;
        try {
            if (node.IsScalar()) height = node.as<double>();
        } catch (const YAML::Exception&) {  // told below
        }
        right = right && height >= 0.0 && height <= 10.0;
        element.heights.push_back(height);
    });
    const auto expected = static_cast<std::size_t>(columns * rows);
    if (!right || element.heights.size() != expected) {
        fields.fail("heights",
                    fmt::format("expected {} x {} numbers from 0 to 10 [m], found {}{}", columns, rows,
                                element.heights.size(), right ? "" : ", some of them wrong"));
        element.heights.clear();
    }
}

void checkText(const YamlFields& fields, const char* key, const std::string& text) {
    constexpr std::string_view Hazard = "hazard:";
    if (text.starts_with(Hazard)) {
        const auto& names = hazardNames();
        if (std::find(names.begin(), names.end(), text.substr(Hazard.size())) == names.end()) {
            fields.fail(key, fmt::format("expected hazard: and one of {}", fmt::join(names, ", ")));
        }
        return;
    }
    if (!text.starts_with("qr:")) return fields.fail(key, "expected \"qr:TEXT\" or \"hazard:NAME\"");
    if (text.size() - 3 > LongestQrText) {
        fields.fail(key, fmt::format("expected at most {} bytes in a QR code, found {}", LongestQrText,
                                     text.size() - 3));
    }
}

VictimTraits readVictim(const YAML::Node& node, const std::string& path, YamlErrors& errors) {
    VictimTraits traits;
    const YamlFields fields(node, path, {"tag", "situation", "waving", "temperature", "co2", "hidden"},
                            errors);
    fields.text("tag", traits.tag);
    if (traits.tag.size() > LongestQrText) {
        fields.fail("tag",
                    fmt::format("expected at most {} bytes, found {}", LongestQrText, traits.tag.size()));
    }
    fields.choice("situation", traits.situation, choicesOf<Situation>(SituationCount));
    fields.flag("waving", traits.waving);
    fields.number("temperature", traits.temperature, ColdestThing, HottestThing);
    fields.number("co2", traits.co2, 0.0, 1e6);
    fields.flag("hidden", traits.hidden);
    return traits;
}

void readTraits(const YAML::Node& node, const YamlFields& fields, const std::string& path, Element& element,
                YamlErrors& errors) {
    const auto only = [&](const char* key, std::initializer_list<ElementKind> kinds) {
        if (!fields.has(key)) return;
        if (std::find(kinds.begin(), kinds.end(), element.kind) != kinds.end()) return;
        fields.fail(key, "expected no such key for a " + toString(element.kind));
    };
    only("width", {ElementKind::Door, ElementKind::Spectator});
    only("angle", {ElementKind::Door});
    only("riser", {ElementKind::Stairs});
    only("cell", {ElementKind::StepField});
    only("heights", {ElementKind::StepField});
    only("text", {ElementKind::Sign});
    only("victim", {ElementKind::Victim});

    fields.number("width", element.width, 0.0, LargestGround);
    double angle = inDegrees(element.angle);
    if (fields.has("angle")) {
        fields.number("angle", angle, -180.0, 180.0);
        element.angle = degrees(angle);
    }
    fields.number("riser", element.riser, 0.005, 1.0);
    fields.number("cell", element.cell, 0.01, 10.0);
    fields.text("text", element.text);
    if (element.kind == ElementKind::StepField) readHeights(fields, element);
    if (element.kind == ElementKind::Stairs && element.size.z() / element.riser > 200.5) {
        fields.fail("riser", "expected at most 200 steps");
    }
    if (element.kind == ElementKind::Sign) checkText(fields, "text", element.text);
    if (element.kind == ElementKind::Victim && fields.has("victim")) {
        element.victim = readVictim(node["victim"], path + ".victim", errors);
    }
}

}  // namespace

Pose readPose(const YamlFields& fields) {
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    Eigen::Vector3d turn = Eigen::Vector3d::Zero();
    if (!fields.has("position")) {
        fields.fail("position", "expected three numbers [m], found nothing");
    } else if (const auto found = fields.numbers("position", 3, FarthestPlace); !found.empty()) {
        position = {found[0], found[1], found[2]};
    }
    if (const auto found = fields.numbers("turn", 3, 360.0); !found.empty())
        turn = {found[0], found[1], found[2]};
    return poseFrom(position, degrees(turn.x()), degrees(turn.y()), degrees(turn.z()));
}

void readSeed(const YamlFields& fields, const char* key, std::uint64_t& seed) {
    if (!fields.has(key)) return;
    std::string text;
    fields.text(key, text);
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (text.empty() || problem != std::errc() || end != text.data() + text.size()) {
        fields.fail(key, fmt::format("expected a whole number from 0 to {}, found \"{}\"", UINT64_MAX,
                                     text.substr(0, 40)));
    }
}

Element readElement(const YAML::Node& node, const std::string& path, double ambient, YamlErrors& errors) {
    const YamlFields fields(node, path,
                            {"kind", "name", "position", "turn", "size", "material", "temperature", "width",
                             "angle", "riser", "cell", "heights", "text", "seed", "victim"},
                            errors);
    if (!node.IsMap()) return elementOf(ElementKind::Wall);
    ElementKind kind = ElementKind::Wall;
    if (!fields.has("kind")) fields.fail("kind", "expected the kind of the element, found nothing");
    fields.choice("kind", kind, choicesOf<ElementKind>(ElementKindCount));
    Element element = elementOf(kind);
    if (!warmByItself(kind)) element.temperature = ambient;
    fields.text("name", element.name);
    element.pose = readPose(fields);
    readSize(fields, element.size);
    fields.choice("material", element.material, choicesOf<Material>(MaterialCount));
    fields.number("temperature", element.temperature, ColdestThing, HottestThing);
    readSeed(fields, "seed", element.seed);
    readTraits(node, fields, path, element, errors);
    return element;
}

}  // namespace leitstand::simulation
