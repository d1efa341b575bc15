#include "widgets/models/frames/frame_rows.h"

#include <algorithm>

#include <QCoreApplication>
#include <QStringList>

#include "core/base/rotation/euler_angles.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::FrameWords)
};

constexpr double Young = 1.0,
                 Old = 5.0;  ///< ages from which they are shown, and from which they are wrong [s]

double ageOf(const FrameNode& node, Time now) {
    return toSeconds(now - node.received);
}

QString trouble(const FrameRow& row) {
    if (row.circle) return Words::tr("It is above itself: tf uses no frame of such a circle");
    if (!row.otherParent.empty())
        return Words::tr("Also below %1: two nodes publish it, and tf jumps between both")
            .arg(othersText(row.otherParent));
    return {};
}

QString hintOf(const FrameRow& row) {
    const FrameNode& node = row.node;
    QStringList lines = {othersText(node.frame)};
    if (row.root) {
        lines += Words::tr("The highest frame of a tree");
        return lines.join(QLatin1Char('\n'));
    }
    const Eigen::Vector3d angles = rollPitchYawOf(node.frameInParent);
    lines += Words::tr("below %1").arg(othersText(node.parent));
    lines += Words::tr("%1 m · roll %2, pitch %3, yaw %4")
                 .arg(positionText(node.frameInParent.translation()), degreesText(angles.x()),
                      degreesText(angles.y()), degreesText(angles.z()));
    lines += othersText(node.topic);
    if (const QString wrong = trouble(row); !wrong.isEmpty()) lines += wrong;
    return lines.join(QLatin1Char('\n'));
}

FrameLine lineOf(const FrameRow& row, Time now) {
    constexpr int Deepest = 20;  // deeper ones are not indented further
    const FrameNode& node = row.node;
    FrameLine line;
    line.frame =
        QString(qsizetype{2} * std::min(row.depth, Deepest), QLatin1Char(' ')) + othersText(node.frame);
    line.hint = hintOf(row);
    if (row.root) {
        line.tone = Tone::Muted;
        return line;
    }
    line.place = positionText(node.frameInParent.translation());
    if (node.fixed)
        line.rate = Words::tr("static");
    else if (node.rate > 0.0)
        line.rate = Words::tr("%1 Hz").arg(numberText(node.rate, node.rate < 10.0 ? 1 : 0));
    const double age = ageOf(node, now);
    if (!node.fixed && age >= Young) line.age = Words::tr("%1 s").arg(numberText(age, 0));
    if (row.circle || !row.otherParent.empty() || (!node.fixed && age >= Old)) line.tone = Tone::Attention;
    return line;
}

}  // namespace

std::vector<FrameLine> frameLines(const std::vector<FrameRow>& rows, Time now) {
    std::vector<FrameLine> lines;
    lines.reserve(rows.size());
    for (const FrameRow& row : rows) lines.push_back(lineOf(row, now));
    return lines;
}

QString framesSummary(const std::vector<FrameRow>& rows, const std::vector<std::string>& unconnected,
                      bool& attention) {
    attention = false;
    if (rows.empty()) return Words::tr("No transforms came");
    const auto roots =
        std::count_if(rows.begin(), rows.end(), [](const FrameRow& row) { return row.root || row.circle; });
    QStringList parts = {Words::tr("frames: %1").arg(rows.size())};
    if (roots > 1) parts += Words::tr("trees that nothing connects: %1").arg(roots);
    const auto disputed = std::count_if(
        rows.begin(), rows.end(), [](const FrameRow& row) { return row.circle || !row.otherParent.empty(); });
    if (disputed > 0) parts += Words::tr("with two parents or in a circle: %1").arg(disputed);
    QString text = parts.join(QStringLiteral(" · "));
    if (!unconnected.empty()) {
        QStringList names;
        for (const std::string& frame : unconnected) names += othersText(frame);
        text += QLatin1Char('\n') + Words::tr(
                                        "No transforms lead from the base to %1: the places in the robot's "
                                        "file count")
                                        .arg(names.join(QStringLiteral(", ")));
    }
    attention = roots > 1 || disputed > 0;
    return text;
}

void FrameRowsModel::show(const std::vector<FrameLine>& lines) {
    replace(m_lines, lines, [](const FrameLine& a, const FrameLine& b) { return a.frame == b.frame; });
}

QStringList FrameRowsModel::headers() const {
    return {tr("Frame"), tr("x y z [m]"), tr("Rate"), tr("Age")};
}

QString FrameRowsModel::cell(int row, int column) const {
    const FrameLine& line = m_lines[static_cast<std::size_t>(row)];
    switch (column) {
        case Place:
            return line.place;
        case Rate:
            return line.rate;
        case Age:
            return line.age;
        default:
            return line.frame;
    }
}

QString FrameRowsModel::hint(int row) const {
    return m_lines[static_cast<std::size_t>(row)].hint;
}

Tone FrameRowsModel::tone(int row, int /*column*/) const {
    return m_lines[static_cast<std::size_t>(row)].tone;
}

}  // namespace leitstand
