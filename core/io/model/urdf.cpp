#include "core/io/model/urdf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <tinyxml2.h>

#include "core/io/detail/numbers.h"

namespace leitstand {
namespace {

using tinyxml2::XMLElement;

constexpr double Farthest = 1000.0;  ///< of sizes and places [m]; larger ones are millimetres

/// What is wrong with a model, and the line where.
struct Fault {
    int line;
    std::string text;
};

[[noreturn]] void fail(const XMLElement& at, const std::string& text) {
    throw Fault{at.GetLineNum(), text};
}

std::string inQuotes(std::string_view text) {
    constexpr std::size_t Longest = 60;
    return fmt::format("\"{}{}\"", text.substr(0, Longest), text.size() > Longest ? "..." : "");
}

std::string attribute(const XMLElement& element, const char* name) {
    const char* const value = element.Attribute(name);
    if (value == nullptr || *value == '\0')
        fail(element, fmt::format("expected an attribute {} of <{}>", name, element.Name()));
    return value;
}

/// Reads @p count numbers between blanks.
template <std::size_t Count>
std::array<double, Count> numbers(const XMLElement& element, const char* name, std::string_view text,
                                  double most) {
    std::array<double, Count> values{};
    std::string line(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    std::string_view rest = line;
    bool right = true;
    for (double& value : values) {
        const auto found = detail::toNumber(detail::takeField(rest));
        right = right && found && std::abs(*found) <= most;
        value = found.value_or(0.0);
    }
    if (!right || !detail::takeField(rest).empty())
        fail(element, fmt::format("expected {} of <{}> as {} number{} of at most {}, found {}", name,
                                  element.Name(), Count, Count == 1 ? "" : "s", most, inQuotes(text)));
    return values;
}

Eigen::Vector3d vector(const XMLElement& element, const char* name, const Eigen::Vector3d& usual,
                       double most = Farthest) {
    const char* const text = element.Attribute(name);
    if (text == nullptr) return usual;
    const auto values = numbers<3>(element, name, text, most);
    return {values[0], values[1], values[2]};
}

std::optional<double> number(const XMLElement& element, const char* name, double most) {
    const char* const text = element.Attribute(name);
    if (text == nullptr) return std::nullopt;
    return numbers<1>(element, name, text, most)[0];
}

double length(const XMLElement& element, const char* name) {
    const double value = numbers<1>(element, name, attribute(element, name), Farthest)[0];
    if (value < 0.0) fail(element, fmt::format("expected {} of at least 0, found {}", name, value));
    return value;
}

/// Returns the pose of <origin>: rotated about x, then y, then z of the parent.
Pose originOf(const XMLElement& element) {
    const XMLElement* const origin = element.FirstChildElement("origin");
    if (origin == nullptr) return Pose::Identity();
    const Eigen::Vector3d angles = vector(*origin, "rpy", Eigen::Vector3d::Zero());
    return poseFrom(vector(*origin, "xyz", Eigen::Vector3d::Zero()), angles.x(), angles.y(), angles.z());
}

PartShape shapeOf(const XMLElement& geometry) {
    const XMLElement* const shape = geometry.FirstChildElement();
    if (shape == nullptr) fail(geometry, "expected box, cylinder, sphere or mesh, found nothing");
    const std::string_view kind = shape->Name();
    if (kind == "box") {
        attribute(*shape, "size");
        const Eigen::Vector3d size = vector(*shape, "size", Eigen::Vector3d::Zero());
        if (size.minCoeff() < 0.0) fail(*shape, "expected a size of at least 0");
        return BoxShape{size};
    }
    if (kind == "cylinder") return CylinderShape{length(*shape, "radius"), length(*shape, "length")};
    if (kind == "sphere") return SphereShape{length(*shape, "radius")};
    if (kind == "mesh")
        return MeshShape{attribute(*shape, "filename"), vector(*shape, "scale", Eigen::Vector3d::Ones())};
    // Of Gazebo's own; a capsule is drawn as the cylinder in it.
    if (kind == "capsule") return CylinderShape{length(*shape, "radius"), length(*shape, "length")};
    fail(geometry, fmt::format("expected box, cylinder, sphere or mesh, found {}", kind));
}

using Colours = std::map<std::string, PartColour>;

std::optional<PartColour> colourIn(const XMLElement& material) {
    const XMLElement* const colour = material.FirstChildElement("color");
    if (colour == nullptr) return std::nullopt;
    const auto rgba = numbers<4>(*colour, "rgba", attribute(*colour, "rgba"), Farthest);
    return PartColour(static_cast<float>(std::clamp(rgba[0], 0.0, 1.0)),
                      static_cast<float>(std::clamp(rgba[1], 0.0, 1.0)),
                      static_cast<float>(std::clamp(rgba[2], 0.0, 1.0)));
}

std::optional<PartColour> colourOf(const XMLElement& part, const Colours& known) {
    const XMLElement* const material = part.FirstChildElement("material");
    if (material == nullptr) return std::nullopt;
    if (auto own = colourIn(*material)) return own;
    const char* const name = material->Attribute("name");
    const auto found = known.find(name == nullptr ? "" : name);
    return found == known.end() ? std::nullopt : std::optional(found->second);
}

Colours coloursOf(const XMLElement& robot) {
    Colours colours;
    const auto take = [&](const XMLElement& material) {
        const char* const name = material.Attribute("name");
        if (name == nullptr) return;
        if (auto colour = colourIn(material)) colours.try_emplace(name, *colour);
    };
    for (const auto* one = robot.FirstChildElement("material"); one != nullptr;
         one = one->NextSiblingElement("material"))
        take(*one);
    // A material may be defined where it is used first.
    for (const auto* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
        for (const auto* visual = link->FirstChildElement("visual"); visual != nullptr;
             visual = visual->NextSiblingElement("visual")) {
            if (const auto* const material = visual->FirstChildElement("material")) take(*material);
        }
    }
    return colours;
}

/// Reads a model. Throws Fault.
class Reader {
public:
    explicit Reader(const XMLElement& robot) : m_robot(robot), m_colours(coloursOf(robot)) {}

    RobotModel read() {
        if (const char* const name = m_robot.Attribute("name")) m_model.name = name;
        for (const auto* link = m_robot.FirstChildElement("link"); link != nullptr;
             link = link->NextSiblingElement("link"))
            addLink(*link);
        if (m_model.links.empty()) fail(m_robot, "expected at least one <link>");
        for (const auto* joint = m_robot.FirstChildElement("joint"); joint != nullptr;
             joint = joint->NextSiblingElement("joint"))
            addJoint(*joint);
        arrange();
        return std::move(m_model);
    }

private:
    void addLink(const XMLElement& element) {
        ModelLink link;
        link.name = attribute(element, "name");
        if (m_model.links.size() >= RobotModel::MostLinks)
            fail(element, fmt::format("expected at most {} links", RobotModel::MostLinks));
        if (!m_linkAt.emplace(link.name, m_model.links.size()).second)
            fail(element, fmt::format("expected a name of its own, found {} again", inQuotes(link.name)));
        addParts(element, "visual", link.visuals);
        addParts(element, "collision", link.collisions);
        m_model.links.push_back(std::move(link));
    }

    void addParts(const XMLElement& link, const char* kind, std::vector<LinkPart>& parts) {
        for (const auto* one = link.FirstChildElement(kind); one != nullptr;
             one = one->NextSiblingElement(kind)) {
            const XMLElement* const geometry = one->FirstChildElement("geometry");
            if (geometry == nullptr) fail(*one, fmt::format("expected <geometry> in <{}>", kind));
            if (++m_parts > RobotModel::MostParts)
                fail(*one, fmt::format("expected at most {} shapes in all", RobotModel::MostParts));
            parts.push_back({originOf(*one), shapeOf(*geometry), colourOf(*one, m_colours)});
        }
    }

    std::size_t linkOf(const XMLElement& joint, const char* end) {
        const XMLElement* const element = joint.FirstChildElement(end);
        if (element == nullptr) fail(joint, fmt::format("expected <{}> in <joint>", end));
        const std::string name = attribute(*element, "link");
        const auto found = m_linkAt.find(name);
        if (found == m_linkAt.end())
            fail(*element, fmt::format("expected a link of the model, found {}", inQuotes(name)));
        return found->second;
    }

    void addJoint(const XMLElement& element) {
        const std::map<std::string_view, ModelJointType> types = {
            {"fixed", ModelJointType::Fixed},         {"revolute", ModelJointType::Revolute},
            {"prismatic", ModelJointType::Prismatic}, {"continuous", ModelJointType::Continuous},
            {"floating", ModelJointType::Fixed},      {"planar", ModelJointType::Fixed}};
        ModelJoint joint;
        joint.name = attribute(element, "name");
        const std::string type = attribute(element, "type");
        const auto found = types.find(type);
        if (found == types.end())
            fail(element, fmt::format("expected fixed, revolute, continuous, prismatic, floating or planar, "
                                      "found {}",
                                      inQuotes(type)));
        joint.type = found->second;
        joint.parent = linkOf(element, "parent");
        joint.child = linkOf(element, "child");
        joint.jointInParent = originOf(element);
        if (const auto* const axis = element.FirstChildElement("axis")) {
            joint.axis = vector(*axis, "xyz", joint.axis);
            if (joint.axis.norm() < 1e-9) fail(*axis, "expected an axis other than 0 0 0");
            joint.axis.normalize();
        }
        constexpr double Widest = 1e6;  // [rad] or [m]; "no limit" in some files
        const auto* const limit = element.FirstChildElement("limit");
        if (limit != nullptr && joint.type != ModelJointType::Continuous) {
            joint.lower = number(*limit, "lower", Widest);
            joint.upper = number(*limit, "upper", Widest);
            if (joint.lower.value_or(0.0) > joint.upper.value_or(0.0)) joint.lower = joint.upper = {};
        }
        if (const auto* const mimic = element.FirstChildElement("mimic")) {
            joint.mimics =
                MimickedJoint{attribute(*mimic, "joint"), number(*mimic, "multiplier", Widest).value_or(1.0),
                              number(*mimic, "offset", Widest).value_or(0.0)};
        }
        m_lines.push_back(element.GetLineNum());
        m_model.joints.push_back(std::move(joint));
    }

    /// Puts the joints in an order from the root outwards. Fails where they are no tree.
    void arrange() {
        const std::size_t links = m_model.links.size();
        std::vector<std::vector<std::size_t>> below(links);
        std::vector<bool> hasParent(links, false);
        for (std::size_t i = 0; i < m_model.joints.size(); ++i) {
            const ModelJoint& joint = m_model.joints[i];
            if (hasParent[joint.child])
                throw Fault{m_lines[i], fmt::format("expected one parent of link {}, found a second one",
                                                    inQuotes(m_model.links[joint.child].name))};
            hasParent[joint.child] = true;
            below[joint.parent].push_back(i);
        }
        const auto roots = std::count(hasParent.begin(), hasParent.end(), false);
        if (roots != 1) fail(m_robot, fmt::format("expected one link without a parent, found {}", roots));
        m_model.root = static_cast<std::size_t>(std::find(hasParent.begin(), hasParent.end(), false) -
                                                hasParent.begin());
        std::vector<ModelJoint> ordered;
        std::vector<std::size_t> next = {m_model.root};
        for (std::size_t i = 0; i < next.size(); ++i) {
            for (const std::size_t joint : below[next[i]]) {
                next.push_back(m_model.joints[joint].child);
                ordered.push_back(std::move(m_model.joints[joint]));
            }
        }
        // With one root and one parent each, links that were not reached form a circle.
        if (next.size() != links) fail(m_robot, "expected a tree of links, found a circle");
        m_model.joints = std::move(ordered);
    }

    const XMLElement& m_robot;
    Colours m_colours;
    RobotModel m_model;
    std::map<std::string, std::size_t> m_linkAt;
    std::vector<int> m_lines;  ///< of the joints
    std::size_t m_parts = 0;
};

}  // namespace

Result<RobotModel> readUrdf(const std::string& text, const std::string& name) {
    tinyxml2::XMLDocument document;
    if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
        return Error{fmt::format("{}:{}: expected XML ({})", name, document.ErrorLineNum(),
                                 tinyxml2::XMLDocument::ErrorIDToName(document.ErrorID()))};
    const XMLElement* const robot = document.FirstChildElement("robot");
    if (robot == nullptr) return Error{fmt::format("{}:1: expected <robot>, as in URDF", name)};
    try {
        return Reader(*robot).read();
    } catch (const Fault& fault) {
        return Error{fmt::format("{}:{}: {}", name, fault.line, fault.text)};
    }
}

}  // namespace leitstand
