#include "widgets/models/live/robot_chip.h"

#include <cmath>

#include <QCoreApplication>

#include "widgets/models/live/freshness.h"
#include "widgets/models/live/link_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct ChipTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RobotChip)
};

/// @p parts that are not empty, with dots between.
QString joined(const QStringList& parts) {
    QStringList full = parts;
    full.removeAll(QString());
    return full.join(QStringLiteral(" · "));
}

QString batteryOf(const RobotState& said) {
    if (!said.battery || !std::isfinite(said.battery->sample.fraction)) return {};
    return percentText(said.battery->sample.fraction);
}

/// @p label within a line. The name of a mode is written as the language writes it: German has capitals.
QString inALine(const ModeLabel& label, const std::optional<Latest<ModeSample>>& said) {
    const QString name = said ? modeName(said->sample.mode) : QString(), large = name.toUpper();
    if (large.isEmpty() || !label.text.startsWith(large)) return label.text.toLower();
    return name + label.text.sliced(large.size()).toLower();
}

}  // namespace

RobotChip robotChipOf(const RobotFace& face, const RobotView& robot, const RobotState& said) {
    RobotChip chip;
    chip.face = face;
    chip.link = robot.link.state;
    const ModeLabel label = modeLabelOf(robot, said.mode);
    chip.mode = label.kind;
    chip.tone = chip.link == LinkState::Lost ? Tone::Attention : Tone::Muted;
    const QString mode = inALine(label, said.mode), battery = batteryOf(said);
    const bool talks = chip.link == LinkState::Connected || chip.link == LinkState::Degraded;
    QString trip = talks ? roundTripText(robot.link) : QString();
    QString loss = talks ? lossShareText(robot.link) : QString();
    const QString reason = worstReasonText(robot.link);
    if (chip.link == LinkState::Lost) trip = secondsText(robot.link.silence);
    if (chip.link == LinkState::Degraded && !reason.isEmpty()) trip = reason, loss = QString();
    chip.texts = QStringList{
        joined({face.title + QChar(0x2002) + joined({trip, loss, battery, mode})}),
        joined({trip, loss, battery, mode}),
        joined({trip, battery, mode}),
        joined({battery, mode}),
    };
    // The battery of a robot that says nothing is an old one: a bar that is full goes without.
    if (!talks) chip.texts += mode;
    chip.texts.removeDuplicates();
    chip.details = ChipTexts::tr("%1 (%2): %3 · link %4")
                       .arg(face.title, face.letter, joined({mode, label.reason, battery}),
                            joined({linkStateText(chip.link), reason, roundTripText(robot.link),
                                    talks ? lossShareText(robot.link) : QString()}));
    return chip;
}

}  // namespace leitstand
