#include "widgets/models/joints/joint_texts.h"

#include <cmath>
#include <optional>

#include <QCoreApplication>

#include "core/base/pose.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::JointTexts)
};

QString positionText(const MovedJoint& joint, std::optional<double> position) {
    if (!position) return QStringLiteral("–");
    if (joint.type == JointType::Prismatic) return Words::tr("%1 m").arg(*position, 0, 'f', 3);
    return Words::tr("%1°").arg(inDegrees(*position), 0, 'f', 0);
}

QString limitsText(const MovedJoint& joint) {
    if (!joint.lower || !joint.upper) return {};
    return Words::tr(" (%1 to %2)").arg(positionText(joint, joint.lower), positionText(joint, joint.upper));
}

}  // namespace

std::vector<JointAxisId> jointAxes(const RobotDescription& robot) {
    std::vector<JointAxisId> all;
    for (const JointGroup& group : robot.jointGroups) {
        for (std::size_t axis = 0; axis < group.axes.size(); ++axis) all.push_back({group.name, axis});
    }
    return all;
}

std::vector<JointRow> jointRows(const RobotDescription& robot, const JointGroupViews& now) {
    std::vector<JointRow> rows;
    for (const JointGroup& group : robot.jointGroups) {
        const auto view = now.find(group.name);
        const auto positionOf = [&](std::size_t joint) -> std::optional<double> {
            if (view == now.end() || joint >= view->second.positions.size()) return std::nullopt;
            return view->second.positions[joint];
        };
        for (std::size_t axis = 0; axis < group.axes.size(); ++axis) {
            JointRow row{{group.name, axis}, othersText(group.axes[axis].title), {}, {}};
            QStringList shown, joints;
            for (const std::size_t i : group.axes[axis].joints) {
                const MovedJoint& joint = group.joints[i];
                const QString position = positionText(joint, positionOf(i));
                if (!shown.contains(position)) shown += position;
                joints += othersText(joint.name) + QStringLiteral(": ") + position + limitsText(joint);
            }
            row.position = shown.join(QStringLiteral(" / "));
            row.joints = joints.join(QLatin1Char('\n'));
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

QString jointStatus(const JointGroup& group, const JointGroupView& now) {
    const QString title = othersText(group.title);
    switch (now.motion) {
        case JointMotion::Blocked:
            return Words::tr("%1: blocked, given up").arg(title);
        case JointMotion::Unreported:
            return Words::tr("%1: the robot does not tell where they are").arg(title);
        case JointMotion::ToPreset:
            if (now.preset && *now.preset < group.presets.size())
                return Words::tr("%1: to %2").arg(title, othersText(group.presets[*now.preset].title));
            return {};
        case JointMotion::ByHand:
            return {};
        case JointMotion::Still:
            return now.mayMove ? QString() : Words::tr("%1: no drive control").arg(title);
    }
    return {};
}

Tone jointTone(const JointGroupView& now) {
    const bool odd = now.motion == JointMotion::Blocked || now.motion == JointMotion::Unreported;
    return odd ? Tone::Attention : Tone::Normal;
}

void JointRowsModel::show(const std::vector<JointRow>& rows) {
    replace(m_rows, rows, [](const JointRow& a, const JointRow& b) { return a.id == b.id; });
}

QStringList JointRowsModel::headers() const {
    return {JointRowsModel::tr("Joints"), JointRowsModel::tr("Position")};
}

QString JointRowsModel::cell(int row, int column) const {
    const JointRow& one = m_rows[static_cast<std::size_t>(row)];
    return column == Title ? one.title : one.position;
}

QString JointRowsModel::hint(int row) const {
    return m_rows[static_cast<std::size_t>(row)].joints;
}

}  // namespace leitstand
