#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/base/rotation/euler_angles.h"
#include "robots/simulation/arena/arena_file.h"

namespace leitstand::simulation {
namespace {

/// Returns the shortest number of degrees from which the reader gets @p radians again.
double degreesOf(double radians) {
    const double exact = inDegrees(radians);
    const double rounded = std::round(exact * 1e6) / 1e6;
    return degrees(rounded) == radians ? rounded : exact;
}

/// Returns roll, pitch and yaw [degrees], rounded when the rounded numbers give the same pose.
Eigen::Vector3d turnOf(const Pose& pose) {
    const Eigen::Vector3d exact =
        rollPitchYawOf(pose).unaryExpr([](double radians) { return inDegrees(radians); });
    // 270 and -90 degrees differ in the last digit of their cosine.
    for (const double whole : {0.0, 360.0}) {
        Eigen::Vector3d rounded = exact.unaryExpr([](double one) { return std::round(one * 1e6) / 1e6; });
        if (rounded.z() <= 0.0) rounded.z() += whole;
        rounded = rounded.unaryExpr([](double one) { return one + 0.0; });  // no minus before a zero
        const Pose again =
            poseFrom(pose.translation(), degrees(rounded.x()), degrees(rounded.y()), degrees(rounded.z()));
        if (again.matrix() == pose.matrix()) return rounded;
    }
    return exact;
}

/// Returns @p text quoted and escaped, so that YAML reads it unchanged.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char one : text) {
        const auto code = static_cast<unsigned char>(one);
        if (one == '"' || one == '\\') {
            out += '\\';
            out += one;
        } else if (code < 0x20 || code == 0x7F) {
            out += fmt::format("\\x{:02x}", code);
        } else {
            out += one;
        }
    }
    return out + '"';
}

std::string poseText(const Pose& pose) {
    const Eigen::Vector3d at = pose.translation();
    const Eigen::Vector3d turn = turnOf(pose);
    std::string text = fmt::format("position: [{}, {}, {}]", at.x(), at.y(), at.z());
    if (turn != Eigen::Vector3d::Zero())
        text += fmt::format(", turn: [{}, {}, {}]", turn.x(), turn.y(), turn.z());
    return text;
}

std::string victimText(const VictimTraits& traits) {
    return fmt::format("{{tag: {}, situation: {}, waving: {}, temperature: {}, co2: {}, hidden: {}}}",
                       quoted(traits.tag), toString(traits.situation), traits.waving, traits.temperature,
                       traits.co2, traits.hidden);
}

std::string elementText(const Element& element, double ambient) {
    const Element usual = elementOf(element.kind);
    std::string text = fmt::format("  - {{kind: {}, name: {}, {}, size: [{}, {}, {}]", toString(element.kind),
                                   quoted(element.name), poseText(element.pose), element.size.x(),
                                   element.size.y(), element.size.z());
    const auto add = [&text](const char* key, const auto& value) {
        text += fmt::format(", {}: {}", key, value);
    };
    if (element.material != usual.material) add("material", toString(element.material));
    if (element.temperature != (warmByItself(element.kind) ? usual.temperature : ambient)) {
        add("temperature", element.temperature);
    }
    if (element.width != usual.width) add("width", element.width);
    if (element.angle != usual.angle) add("angle", degreesOf(element.angle));
    if (element.riser != usual.riser) add("riser", element.riser);
    if (element.cell != usual.cell) add("cell", element.cell);
    if (element.reach != usual.reach) add("reach", element.reach);
    if (!element.text.empty()) add("text", quoted(element.text));
    if (element.seed != usual.seed) add("seed", element.seed);
    if (!element.heights.empty())
        text += fmt::format(",\n     heights: [{}]", fmt::join(element.heights, ", "));
    if (element.victim) text += ",\n     victim: " + victimText(*element.victim);
    return text + "}\n";
}

}  // namespace

std::string writeArena(const Arena& arena) {
    std::string text = "# An arena of Leitstand's simulation; docs/simulation.md tells about the keys.\n";
    text +=
        fmt::format("name: {}\ngrade: {}\nseed: {}\nfrom: [{}, {}]\nto: [{}, {}]\nambient: {}\nlight: {}\n",
                    quoted(arena.name), toString(arena.grade), arena.seed, arena.from.x(), arena.from.y(),
                    arena.to.x(), arena.to.y(), arena.ambient, arena.light);
    if (!arena.starts.empty()) text += "starts:\n";
    for (const auto& [robot, start] : arena.starts)
        text += fmt::format("  {}: {{{}}}\n", quoted(robot), poseText(start));
    text += arena.elements.empty() ? "elements: []\n" : "elements:\n";
    for (const Element& element : arena.elements) text += elementText(element, arena.ambient);
    return text;
}

}  // namespace leitstand::simulation
