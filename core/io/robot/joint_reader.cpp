#include "core/io/robot/joint_reader.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/base/pose.h"
#include "core/base/words.h"
#include "core/io/robot/robot_keys.h"
#include "core/io/robot/robot_names.h"

namespace leitstand::detail {
namespace {

constexpr double UsualTurn = degrees(45), FastestTurn = degrees(720);  // [rad/s]
constexpr double UsualSlide = 0.05, FastestSlide = 2.0;                // [m/s]
constexpr double FarthestTurn = degrees(3600), FarthestSlide = 10.0;   // [rad], [m]
constexpr double LongestLink = 10.0;                                   // [m]
constexpr std::size_t MostGroups = 8;

/// Numbers in a file as the program has them: degrees of angles, metres as they are.
struct Measure {
    double one;  ///< of what the file says, in the program
    double farthest, usualRate, fastest;
    const char* unit;
    const char* rateUnit;
};

Measure measureOf(JointType type) {
    if (type == JointType::Revolute)
        return {degrees(1), FarthestTurn, UsualTurn, FastestTurn, " degrees", " degrees/s"};
    return {1.0, FarthestSlide, UsualSlide, FastestSlide, " m", " m/s"};
}

bool readName(const YamlFields& fields, std::string& name) {
    const char* const words =
        translatable("leitstand::Error", "expected a name of the group, of letters, digits and _, found {}");
    if (!fields.has("name"))
        return fields.fail("name", leitstand::fill(translate("leitstand::Error", words),
                                                   translate("leitstand::Error", "nothing")));
    if (!fields.text("name", name)) return false;
    if (isName(name)) return true;
    return fields.fail("name", leitstand::fill(translate("leitstand::Error", words), shown(name)));
}

class GroupReader {
public:
    GroupReader(const YamlPlace& place, YamlErrors& errors)
        : m_fields(place, JointGroupKeys, errors), m_errors(errors) {}

    /// Returns false when the group has no name, or no joints.
    bool read(JointGroup& group) {
        if (!readName(m_fields, group.name)) return false;
        group.title = group.name;
        m_fields.text("title", group.title);
        m_fields.choice("command", group.mode, jointCommandWords());
        if (!readJoints(group)) return false;
        readAxes(group);
        readPresets(group);
        return true;
    }

    [[nodiscard]] const YamlFields& fields() const { return m_fields; }

private:
    /// Returns the entries of a list of at most @p most.
    std::vector<YamlPlace> some(const char* key, std::size_t most) const {
        std::vector<YamlPlace> places = m_fields.list(key);
        if (places.size() > most) {
            m_fields.fail(key, leitstand::fill(translate("leitstand::Error", "expected at most {}, found {}"),
                                               most, places.size()));
            places.resize(most);
        }
        return places;
    }

    bool readJoints(JointGroup& group) {
        if (!m_fields.has("joints") || m_fields.list("joints").empty())
            return m_fields.fail("joints",
                                 translate("leitstand::Error", "expected a list of joints, found none"));
        for (const YamlPlace& place : some("joints", JointGroup::MostJoints)) {
            const YamlFields one(place, JointKeys, m_errors);
            MovedJoint joint;
            if (!place.value.IsMap()) continue;
            if (!one.has("name")) {
                one.fail("name", translate("leitstand::Error",
                                           "expected the name of a joint as in joint_states, found nothing"));
                continue;
            }
            if (!one.text("name", joint.name)) continue;
            if (group.indexOf(joint.name)) {
                one.fail("name", leitstand::fill(translate("leitstand::Error",
                                                           "expected each joint once, found {} again"),
                                                 shown(joint.name)));
                continue;
            }
            readJoint(one, group, joint);
            group.joints.push_back(std::move(joint));
        }
        return !group.joints.empty();
    }

    void readJoint(const YamlFields& fields, const JointGroup& group, MovedJoint& joint) {
        fields.choice("type", joint.type, jointTypeWords());
        const Measure measure = measureOf(joint.type);
        const double farthest = measure.farthest / measure.one;
        const auto limit = [&](const char* key, std::optional<double>& to) {
            double value = 0.0;
            if (fields.has(key) && fields.number(key, value, -farthest, farthest, measure.unit))
                to = value * measure.one;
        };
        limit("lower", joint.lower);
        limit("upper", joint.upper);
        if (joint.lower && joint.upper && *joint.lower >= *joint.upper)
            fields.fail(
                "lower",
                leitstand::fill(translate("leitstand::Error", "expected less than upper, {}{}, found {}"),
                                *joint.upper / measure.one, measure.unit, *joint.lower / measure.one));
        if (joint.type == JointType::Prismatic && (!joint.lower || !joint.upper))
            fields.fail("lower", translate("leitstand::Error",
                                           "expected lower and upper of a prismatic joint, found not both"));
        double rate = measure.usualRate / measure.one;
        fields.number("rate", rate, 1e-3, measure.fastest / measure.one, measure.rateUnit);
        joint.rate = rate * measure.one;
        fields.flag("reversed", joint.reversed);
        if (fields.has("link")) joint.link = linkOf(fields.at("link"), group);
    }

    JointLink linkOf(const YamlPlace& place, const JointGroup& group) const {
        const YamlFields fields(place, JointLinkKeys, m_errors);
        JointLink link;
        std::vector<double> at = {0.0, 0.0};
        fields.numbers("at", at, 2, LongestLink, " m");
        link.place = {at[0], at[1]};
        if (!fields.has("length"))
            fields.fail("length", translate("leitstand::Error", "expected how long it is, found nothing"));
        fields.number("length", link.length, 0.001, LongestLink, " m");
        double zero = 0.0;
        if (fields.number("zero", zero, -360.0, 360.0, " degrees")) link.zero = degrees(zero);
        fields.text("parent", link.parent);
        if (!link.parent.empty() && !group.indexOf(link.parent))
            fields.fail("parent",
                        leitstand::fill(
                            translate("leitstand::Error", "expected a joint that stands before it, found {}"),
                            shown(link.parent)));
        return link;
    }

    void readAxes(JointGroup& group) {
        if (!m_fields.has("axes")) {
            for (std::size_t i = 0; i < group.joints.size(); ++i)
                group.axes.push_back({group.joints[i].name, {i}});
            return;
        }
        for (const YamlPlace& place : some("axes", JointGroup::MostJoints)) {
            const YamlFields one(place, JointAxisKeys, m_errors);
            JointAxis axis;
            if (!place.value.IsMap()) continue;
            for (const YamlPlace& name : one.list("joints")) {
                const std::string joint = name.value.IsScalar() ? name.value.Scalar() : std::string();
                const auto at = group.indexOf(joint);
                if (at && std::count(axis.joints.begin(), axis.joints.end(), *at) == 0) {
                    axis.joints.push_back(*at);
                } else {
                    m_errors.add(name.line, name.path,
                                 leitstand::fill(translate("leitstand::Error",
                                                           "expected one of the group's joints, each once, "
                                                           "found {}"),
                                                 shown(name.value)));
                }
            }
            if (axis.joints.empty()) {
                one.fail("joints", translate("leitstand::Error", "expected a list of joints, found none"));
                continue;
            }
            axis.title = group.joints[axis.joints.front()].name;
            one.text("title", axis.title);
            group.axes.push_back(std::move(axis));
        }
    }

    void readPresets(JointGroup& group) {
        if (!m_fields.has("presets")) return;
        for (const YamlPlace& place : some("presets", JointGroup::MostPresets)) {
            const YamlFields one(place, JointPresetKeys, m_errors);
            if (!place.value.IsMap()) continue;
            JointPreset preset;
            if (!one.has("title")) {
                one.fail("title", translate("leitstand::Error", "expected its title, found nothing"));
                continue;
            }
            if (!one.text("title", preset.title)) continue;
            if (readPositions(one, group, preset)) group.presets.push_back(std::move(preset));
        }
    }

    static bool readPositions(const YamlFields& fields, const JointGroup& group, JointPreset& preset) {
        if (!fields.has("positions"))
            return fields.fail(
                "positions",
                leitstand::fill(
                    translate("leitstand::Error", "expected {} positions, one for each joint, found none"),
                    group.joints.size()));
        std::vector<double> values(group.joints.size(), 0.0);
        if (!fields.numbers("positions", values, group.joints.size(), FarthestTurn / degrees(1), ""))
            return false;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const MovedJoint& joint = group.joints[i];
            const double position = values[i] * measureOf(joint.type).one;
            constexpr double Slack = 1e-9;
            if (std::abs(joint.within(position) - position) > Slack)
                return fields.fail(
                    "positions",
                    leitstand::fill(translate("leitstand::Error", "expected {} within its limits, found {}"),
                                    joint.name, values[i]));
            preset.positions.push_back(position);
        }
        return true;
    }

    YamlFields m_fields;
    YamlErrors& m_errors;
};

}  // namespace

void readJointGroups(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("joint_groups")) return;
    const std::vector<YamlPlace> places = fields.list("joint_groups");
    if (places.size() > MostGroups)
        fields.fail("joint_groups",
                    leitstand::fill(translate("leitstand::Error", "expected at most {}, found {}"),
                                    MostGroups, places.size()));
    for (std::size_t i = 0; i < std::min(places.size(), MostGroups); ++i) {
        if (!places[i].value.IsMap()) {
            const YamlFields refused(places[i], JointGroupKeys, errors);  // says what was expected
            continue;
        }
        GroupReader reader(places[i], errors);
        JointGroup group;
        if (!reader.read(group)) continue;
        const bool known = std::any_of(robot.jointGroups.begin(), robot.jointGroups.end(),
                                       [&](const JointGroup& one) { return one.name == group.name; });
        if (known) {
            reader.fields().fail(
                "name",
                leitstand::fill(translate("leitstand::Error", "expected a name of its own, found {} again"),
                                shown(group.name)));
            continue;
        }
        robot.jointGroups.push_back(std::move(group));
    }
}

void checkJointCommands(const YamlFields& fields, const RobotDescription& robot) {
    for (const JointGroup& group : robot.jointGroups) {
        if (robot.commandsOf(group) != nullptr) continue;
        fields.fail(
            "joint_groups",
            leitstand::fill(translate("leitstand::Error",
                                      "expected a stream joint_command with the group {}, found none"),
                            shown(group.name)));
    }
}

}  // namespace leitstand::detail
