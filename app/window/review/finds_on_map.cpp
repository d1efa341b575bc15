#include "app/window/review/finds_on_map.h"

#include <QAction>
#include <QMainWindow>

#include "app/session/review/review_evidence.h"
#include "app/window/commands/command_table.h"
#include "app/window/live/map/map_feature.h"
#include "app/window/live/map/map_gestures.h"
#include "app/window/live/map/robots_on_map.h"
#include "app/window/live/selection.h"
#include "app/window/review/finds_feature.h"
#include "app/window/review/review_bridge.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {

FindsOnMap::FindsOnMap(const ViewContext& context, ReviewBridge& bridge, MapFeature& map, FindsFeature& finds)
    : QObject(&context.window), m_context(context), m_bridge(bridge), m_map(map), m_finds(finds) {
    using Kind = VictimSample::Kind;
    QAction& moves =
        add("review.move", tr("Mo&ve the find on the map"), tr("Click on the map where the chosen find is"),
            QKeySequence(Qt::SHIFT | Qt::Key_V));
    moves.setIconText(tr("Move"));
    connect(&moves, &QAction::triggered, this, [this, &moves](bool on) { move(moves, on); });
    finds.offer(moves, FindsFeature::Of::Chosen);
    addFiling("review.file", Kind::Victim, tr("Victim where I &click"), tr("New"),
              QKeySequence(Qt::SHIFT | Qt::Key_F));
    addFiling("review.fileHazard", Kind::Hazard, tr("Hazard where I click"));
    addFiling("review.fileCode", Kind::Code, tr("QR code where I click"));
    addFiling("review.fileObject", Kind::Object, tr("Object where I click"));
}

QAction& FindsOnMap::add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys) {
    return m_context.commands.add({.id = QString::fromLatin1(id),
                                   .menu = CommandMenu::Mission,
                                   .text = text,
                                   .hint = hint,
                                   .keys = keys,
                                   .checkable = true});
}

void FindsOnMap::addFiling(const char* id, VictimSample::Kind kind, const QString& text, const QString& brief,
                           const QKeySequence& keys) {
    QAction& action =
        add(id, text, tr("Then click on the map where it is: filed with the pictures of this moment"), keys);
    connect(&action, &QAction::triggered, this, [this, &action, kind](bool on) { file(action, kind, on); });
    if (brief.isEmpty()) return;
    action.setIconText(brief);
    m_finds.offer(action, FindsFeature::Of::Mission);
}

void FindsOnMap::move(QAction& by, bool on) {
    const auto find = m_finds.chosen();
    if (!on || !find) return m_map.gestures().disarm();
    const QString name = QString::fromStdString(nameOf(find->first, find->second));
    m_map.gestures().armPose(
        by, m_map.robots().placeMark(m_context.selection.name().toStdString()),
        tr("Click where %1 is · right button: not at all").arg(name),
        [this, name, find = *find](const GroundPose& pose) {
            m_bridge.write([find, place = pose.place](ReviewPen& pen) { return pen.move(find, place); },
                           tr("%1 moved (as finished)").arg(name));
        });
}

void FindsOnMap::file(QAction& by, VictimSample::Kind kind, bool on) {
    if (!on || !m_bridge.reviewed()) return m_map.gestures().disarm();
    m_map.gestures().armPose(by, m_map.robots().placeMark(m_context.selection.name().toStdString()),
                             tr("Click where it is · right button: not at all"),
                             [this, kind](const GroundPose& pose) { fileAt(kind, pose.place); });
}

void FindsOnMap::fileAt(VictimSample::Kind kind, const Eigen::Vector3d& placeInMap) {
    const FrozenEvidence seen = evidenceAt(*m_bridge.reviewed(), m_context.selection.name().toStdString(),
                                           m_finds.state(), placeInMap);
    m_bridge.write([kind, seen](ReviewPen& pen) { return pen.file(kind, seen); },
                   tr("%1 filed (as finished)").arg(kindText(kind)));
}

}  // namespace leitstand
