#include "app/window/panes/finds/finds_by_click.h"

#include <algorithm>
#include <utility>

#include <QAction>
#include <QMainWindow>

#include "app/services/review/review_evidence.h"
#include "app/services/review/review_pointing.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/finds/finds_feature.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/panes/map/map_gestures.h"
#include "app/window/panes/map/robots_on_map.h"
#include "app/window/panes/scan/scan_feature.h"
#include "app/window/source/review_bridge.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;

}  // namespace

FindsByClick::FindsByClick(const ReviewContext& context, MapFeature& map, CameraFeature& cameras,
                           ScanFeature& scan, FindsFeature& finds)
    : QObject(&context.window),
      m_context(context),
      m_bridge(context.review),
      m_map(map),
      m_cameras(cameras),
      m_scan(scan),
      m_finds(finds) {
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
    connect(&context.selection, &Selection::changed, this, &FindsByClick::end);  // the ghost is the other's
    connect(&cameras, &CameraFeature::pointed, this, &FindsByClick::fileIn);
    connect(&cameras, &CameraFeature::pointingEnded, this, &FindsByClick::end);
    connect(&scan, &ScanFeature::pointed, this, &FindsByClick::fileBeside);
    connect(&scan, &ScanFeature::pointingEnded, this, &FindsByClick::end);
}

QAction& FindsByClick::add(const char* id, const QString& text, const QString& hint,
                           const QKeySequence& keys) {
    return m_context.commands.add({.id = QString::fromLatin1(id),
                                   .menu = CommandMenu::Mission,
                                   .text = text,
                                   .hint = hint,
                                   .keys = keys,
                                   .checkable = true});
}

void FindsByClick::addFiling(const char* id, FindSample::Kind kind, const QString& text, const QString& brief,
                             const QKeySequence& keys) {
    QAction& action =
        add(id, text,
            tr("Then click on it in a picture, in the virtual scan or on the map: filed with the pictures of "
               "this moment"),
            keys);
    m_filing.emplace_back(kind, &action);
    connect(&action, &QAction::triggered, this, [this, &action, kind](bool on) { file(action, kind, on); });
    connect(&action, &QAction::toggled, this, [this] {
        m_cameras.setPointing(armed());
        m_scan.setPointing(armed());
    });
    if (brief.isEmpty()) return;
    action.setIconText(brief);
    m_finds.offer(action, FindsFeature::Of::Mission);
}

void FindsByClick::move(QAction& by, bool on) {
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

void FindsByClick::file(QAction& by, FindSample::Kind kind, bool on) {
    if (!on || !m_bridge.reviewed()) return m_map.gestures().disarm();
    m_map.gestures().armPose(by, m_map.robots().placeMark(m_context.selection.name().toStdString()),
                             tr("Click where it is · right button: not at all"),
                             [this, kind](const GroundPose& pose) { fileAt(kind, aboveFloor(pose.place)); });
}

void FindsByClick::fileAt(FindSample::Kind kind, const Eigen::Vector3d& placeInMap) {
    const FrozenEvidence seen = evidenceAt(*m_bridge.reviewed(), m_context.selection.name().toStdString(),
                                           m_finds.state(), placeInMap);
    m_bridge.write([kind, seen](ReviewPen& pen) { return pen.file(kind, seen); },
                   tr("%1 filed (as finished)").arg(kindText(kind)));
}

void FindsByClick::fileIn(const PicturePoint& at) {
    const Kind what = kind();
    end();
    if (!m_bridge.reviewed() || !m_bridge.index()) return;
    auto seen = [mission = m_bridge.player().folder(), index = m_bridge.index(), moment = m_bridge.reviewed(),
                 robot = m_context.selection.name().toStdString(), shown = m_finds.state(),
                 at] { return evidenceIn(mission, *index, *moment, robot, shown, at); };
    m_bridge.write(
        [what, seen = std::move(seen)](ReviewPen& pen) -> Result<void> {
            const auto found = seen();
            return found ? pen.file(what, *found) : Result<void>(found.error());
        },
        tr("%1 filed (as finished)").arg(kindText(what)));
}

void FindsByClick::fileBeside(const Eigen::Vector2d& placeInBase) {
    const Kind what = kind();
    end();
    if (!m_bridge.reviewed()) return;
    const std::string name = m_context.selection.name().toStdString();
    for (const RobotInMap& robot : *m_bridge.reviewed()->places) {
        if (robot.robot == name && robot.placed)
            return fileAt(what,
                          robot.baseInMap * Eigen::Vector3d(placeInBase.x(), placeInBase.y(), LyingHeight));
    }
    m_context.notify(tr("The robot was not in the map then: nothing was filed"));
}

void FindsByClick::end() {
    if (armed()) m_map.gestures().disarm();
}

bool FindsByClick::armed() const {
    return std::any_of(m_filing.begin(), m_filing.end(),
                       [](const auto& one) { return one.second->isChecked(); });
}

FindSample::Kind FindsByClick::kind() const {
    for (const auto& [kind, action] : m_filing) {
        if (action->isChecked()) return kind;
    }
    return Kind::Victim;
}

}  // namespace leitstand
