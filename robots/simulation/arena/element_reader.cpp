#include "robots/simulation/arena/element_reader.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "robots/simulation/arena/mesh/qr_code.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"

namespace leitstand::simulation {
namespace {

using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;

constexpr double SmallestSize = 0.001;  ///< [m]
constexpr double HighestStep = 10.0;    ///< of a step field [m]
constexpr int MostCells = 100;          ///< of a step field, along each edge

template <class T>
std::vector<std::pair<std::string, T>> choicesOf(int count) {
    std::vector<std::pair<std::string, T>> choices;
    for (int i = 0; i < count; ++i) choices.emplace_back(toString(static_cast<T>(i)), static_cast<T>(i));
    return choices;
}

constexpr std::array<std::string_view, 16> ElementKeys = {
    "kind",  "name",  "position", "turn",    "size", "material", "temperature", "width",
    "angle", "riser", "cell",     "heights", "text", "seed",     "victim",      "reach"};
constexpr std::array<std::string_view, 6> VictimKeys = {"tag",         "situation", "waving",
                                                        "temperature", "co2",       "hidden"};

void readSize(const YamlFields& fields, Eigen::Vector3d& size) {
    std::vector<double> found;
    if (!fields.numbers("size", found, 3, LargestGround, " m") || found.empty()) return;
    if (*std::min_element(found.begin(), found.end()) < SmallestSize) {
        fields.fail("size", fmt::format("expected 3 numbers from {} to {} m", SmallestSize, LargestGround));
    } else {
        size = {found[0], found[1], found[2]};
    }
}

void readHeights(const YamlFields& fields, Element& element) {
    const double columns = std::round(element.size.x() / element.cell);
    const double rows = std::round(element.size.y() / element.cell);
    if (columns < 1 || rows < 1 || columns > MostCells || rows > MostCells) {
        fields.fail("cell", fmt::format("expected 1 to {} cells along each edge of the size", MostCells));
        return;
    }
    if (!fields.has("heights")) return;
    bool right = true;
    for (const YamlPlace& place : fields.list("heights")) {
        double height = -1.0;
        right = right && detail::isNumber(place.value, height) && height >= 0.0 && height <= HighestStep;
        element.heights.push_back(height);
    }
    const auto expected = static_cast<std::size_t>(columns * rows);
    if (!right || element.heights.size() != expected) {
        fields.fail("heights",
                    fmt::format("expected {} x {} numbers from 0 to {} m, found {}{}", columns, rows,
                                HighestStep, element.heights.size(), right ? "" : ", some of them wrong"));
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
    if (!text.starts_with("qr:")) {
        fields.fail(key, "expected \"qr:TEXT\" or \"hazard:NAME\"");
    } else if (text.size() - 3 > LongestQrText) {
        fields.fail(key, fmt::format("expected at most {} bytes in a QR code, found {}", LongestQrText,
                                     text.size() - 3));
    }
}

VictimTraits readVictim(const YamlPlace& place, YamlErrors& errors) {
    VictimTraits traits;
    const YamlFields fields(place, VictimKeys, errors);
    fields.text("tag", traits.tag, true);
    if (traits.tag.size() > LongestQrText) {
        fields.fail("tag",
                    fmt::format("expected at most {} bytes, found {}", LongestQrText, traits.tag.size()));
    }
    fields.choice("situation", traits.situation, choicesOf<Situation>(SituationCount));
    fields.flag("waving", traits.waving);
    fields.number("temperature", traits.temperature, ColdestThing, HottestThing, " degrees C");
    fields.number("co2", traits.co2, 0.0, 1e6, " ppm");
    fields.flag("hidden", traits.hidden);
    return traits;
}

void readTraits(const YamlFields& fields, Element& element, YamlErrors& errors) {
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
    only("reach", {ElementKind::Smoke});

    fields.number("width", element.width, 0.0, LargestGround, " m");
    double angle = inDegrees(element.angle);
    if (fields.has("angle")) {
        fields.number("angle", angle, -180.0, 180.0, " degrees");
        element.angle = degrees(angle);
    }
    fields.number("riser", element.riser, 0.005, 1.0, " m");
    fields.number("cell", element.cell, 0.01, 10.0, " m");
    fields.number("reach", element.reach, 0.1, LargestGround, " m");
    fields.text("text", element.text);
    if (element.kind == ElementKind::StepField) readHeights(fields, element);
    if (element.kind == ElementKind::Stairs && element.size.z() / element.riser > 200.5) {
        fields.fail("riser", "expected at most 200 steps");
    }
    if (element.kind == ElementKind::Sign) checkText(fields, "text", element.text);
    if (element.kind == ElementKind::Victim && fields.has("victim")) {
        element.victim = readVictim(fields.at("victim"), errors);
    }
}

}  // namespace

Pose readPose(const YamlFields& fields) {
    std::vector<double> position = {0.0, 0.0, 0.0};
    std::vector<double> turn = {0.0, 0.0, 0.0};
    if (!fields.has("position")) fields.fail("position", "expected 3 numbers [m], found nothing");
    fields.numbers("position", position, 3, FarthestPlace, " m");
    fields.numbers("turn", turn, 3, 360.0, " degrees");
    return poseFrom({position[0], position[1], position[2]}, degrees(turn[0]), degrees(turn[1]),
                    degrees(turn[2]));
}

void readSeed(const YamlFields& fields, const char* key, std::uint64_t& seed) {
    if (!fields.has(key)) return;
    const YAML::Node node = fields.at(key).value;
    const std::string text = node.IsScalar() ? node.Scalar() : std::string();
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (text.empty() || problem != std::errc() || end != text.data() + text.size()) {
        fields.fail(key, fmt::format("expected a whole number from 0 to {}, found {}", UINT64_MAX,
                                     detail::shown(node)));
    }
}

Element readElement(const YamlPlace& place, double ambient, YamlErrors& errors) {
    const YamlFields fields(place, ElementKeys, errors);
    if (!place.value.IsMap()) return elementOf(ElementKind::Wall);
    ElementKind kind = ElementKind::Wall;
    if (!fields.has("kind")) fields.fail("kind", "expected the kind of the element, found nothing");
    fields.choice("kind", kind, choicesOf<ElementKind>(ElementKindCount));
    Element element = elementOf(kind);
    if (!warmByItself(kind)) element.temperature = ambient;
    fields.text("name", element.name);
    element.pose = readPose(fields);
    readSize(fields, element.size);
    fields.choice("material", element.material, choicesOf<Material>(MaterialCount));
    fields.number("temperature", element.temperature, ColdestThing, HottestThing, " degrees C");
    readSeed(fields, "seed", element.seed);
    readTraits(fields, element, errors);
    return element;
}

}  // namespace leitstand::simulation
