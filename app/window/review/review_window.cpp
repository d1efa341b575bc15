#include "app/window/review/review_window.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <variant>

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>

#include "app/services/coverage/coverage_replay.h"
#include "app/services/recorded/carried_map.h"
#include "app/services/recorded/review_log.h"
#include "app/window/commands/command_table.h"
#include "app/window/commands/help_commands.h"
#include "app/window/commands/language_commands.h"
#include "app/window/live/cameras/camera_feature.h"
#include "app/window/live/changes/changes_feature.h"
#include "app/window/live/coverage/coverage_feature.h"
#include "app/window/live/frame/key_columns.h"
#include "app/window/live/frame/pane_docks.h"
#include "app/window/live/frame/window_frame.h"
#include "app/window/live/input/selection.h"
#include "app/window/live/layouts/layout_feature.h"
#include "app/window/live/layouts/layout_switch.h"
#include "app/window/live/live_context.h"
#include "app/window/live/map/map_feature.h"
#include "app/window/live/messages/messages_feature.h"
#include "app/window/live/robots/robots_feature.h"
#include "app/window/live/scan/scan_feature.h"
#include "app/window/review/panes/compare_feature.h"
#include "app/window/review/panes/finds_by_click.h"
#include "app/window/review/panes/finds_feature.h"
#include "app/window/review/panes/hand_in_feature.h"
#include "app/window/review/panes/timeline_feature.h"
#include "app/window/review/review_bridge.h"
#include "app/window/review/review_comparison.h"
#include "app/window/review/review_panes.h"
#include "app/window/review/tidying_feature.h"
#include "widgets/map_view/map_view.h"
#include "widgets/models/victims/victim_rows.h"
#include "widgets/painting/elided_label.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand {
namespace {

constexpr int LeastName = 150;  ///< of the mission's name in the bar [px]

}  // namespace

ReviewWindow::ReviewWindow(ReviewBridge& bridge, const MapViewSettings& view, LayoutBook layouts,
                           QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge) {
    keepTextsPlain();
    applyTheme(*qApp, view.theme);  // before there is a widget that would have to be dressed anew
    setWindowTitle(tr("%1 – review – Leitstand")
                       .arg(QString::fromStdString(bridge.player().folder().filename().string())));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    m_selection = new Selection(bridge.robots(), this);
    m_commands = new CommandTable(*this);
    m_panes = new PaneDocks(this);
    const ViewContext context{m_bridge, *m_selection, *m_commands, *m_panes, *this};
    // Each of these makes its panes and commands; the layouts come last, which place and bind them.
    m_timeline = new TimelineFeature(context, bridge);
    m_finds = new FindsFeature(context, bridge);
    addCommands();
    auto* handIn = new HandInFeature(context, bridge, *m_finds);
    connect(handIn, &HandInFeature::told, this, &ReviewWindow::tell);
    m_robots = new RobotsFeature(context);
    m_review = new ReviewPanes(context, bridge);
    m_cameras = new CameraFeature(context);
    m_map = new MapFeature(context, view);
    auto* const tidying = new TidyingFeature(context, m_bridge, m_map->view(), this);
    connect(tidying, &TidyingFeature::told, this, &ReviewWindow::tell);
    connect(tidying, &TidyingFeature::wanted, this, &ReviewWindow::tidyingWanted);
    auto* const scan = new ScanFeature(context);
    auto* const clicks = new FindsByClick(context, bridge, *m_map, *m_cameras, *scan, *m_finds);
    connect(clicks, &FindsByClick::told, this, &ReviewWindow::tell);
    addCoverage(context);
    auto* const changes = new ChangesFeature(context, *m_map);
    connect(changes, &ChangesFeature::told, this, &ReviewWindow::tell);
    m_messages = new MessagesFeature(context);
    auto* compare = new CompareFeature(context, bridge, *m_map);
    connect(compare, &CompareFeature::told, this, &ReviewWindow::tell);
    connect(compare, &CompareFeature::wanted, this, [this] { m_layouts->use(QStringLiteral("compare")); });
    addLanguageCommands(*m_commands, [this](const QString& code) { emit languageWanted(code); });
    m_layouts = new LayoutFeature(context, std::move(layouts), *m_map);
    (new HelpCommands(*this, KeyColumns::review()))->fill(m_commands->menu(CommandMenu::Help));
    m_commands->adopt(CommandMenu::Help);
    build();
    connect(m_selection, &Selection::changed, this,
            [this] { m_bridge.watch(m_selection->name().toStdString()); });
    connect(m_cameras, &CameraFeature::told, this, &ReviewWindow::tell);
    connect(m_timeline, &TimelineFeature::told, this, &ReviewWindow::tell);
    connect(m_finds, &FindsFeature::told, this, &ReviewWindow::tell);
    connect(m_finds, &FindsFeature::marksChanged, m_timeline, &TimelineFeature::setOwnMarks);
    connect(m_layouts, &LayoutFeature::told, this, &ReviewWindow::tell);
    connect(m_finds, &FindsFeature::findsChanged, m_map, [this] {
        m_map->view().setFinds(victimRows(m_finds->state(), std::nullopt), m_finds->chosen());
    });
    connect(&bridge, &MomentSource::told, this, &ReviewWindow::tell);
    m_bridge.watch(m_selection->name().toStdString());
    m_timeline->setOwnMarks(bridge.pen().marks());
    m_bridge.showAgain();
    m_layouts->use(QStringLiteral("review"));
}

ReviewWindow::~ReviewWindow() {
    // What its parts still say while they go has nobody to hear it.
    for (QObject* part : children()) part->disconnect(this);
}

void ReviewWindow::addCoverage(const ViewContext& context) {
    auto* coverage = new CoverageFeature(
        context, *m_map,
        [&bridge = m_bridge,
         replay = std::make_shared<CoverageReplay>(m_bridge.player().folder())](const LiveMoment& moment) {
            if (bridge.index() && moment.mission && moment.places)
                replay->want({moment.now, moment.mission, moment.places, bridge.index()});
            return replay->searched();
        });
    connect(coverage, &CoverageFeature::told, this, &ReviewWindow::tell);
}

void ReviewWindow::addCommands() {
    m_commands->separate(CommandMenu::Mission);
    QAction& again =
        m_commands->add({.id = "review.registerAgain",
                         .menu = CommandMenu::Mission,
                         .text = tr("&Register again…"),
                         .hint = tr("Registers the mission's scans anew, in a window of its own, "
                                    "with settings of your own; the mission stays as it is")});
    connect(&again, &QAction::triggered, this, &ReviewWindow::registerAgainWanted);
    addByHand();
    addMerging();
}

void ReviewWindow::addMerging() {
    QAction& merge = m_commands->add(
        {.id = "review.mergeMaps",
         .menu = CommandMenu::Mission,
         .text = tr("&Merge with the map of…"),
         .hint = tr("Brings the maps of this mission and another one into a new mission, where they have "
                    "seen the same places; both stay as they are")});
    merge.setEnabled(false);
    connect(&merge, &QAction::triggered, this, &ReviewWindow::askToMerge);
    const auto follow = [this, &merge](const ReviewIndexPtr& index) {
        merge.setEnabled(!index->finished->keyScans->empty() && hasMap(m_bridge.player().folder()));
    };
    connect(&m_bridge, &ReviewBridge::opened, this, follow);
    if (m_bridge.index()) follow(m_bridge.index());
}

void ReviewWindow::askToMerge() {
    const std::filesystem::path folder = m_bridge.player().folder();
    auto* choice = new QFileDialog(this, tr("Merge with the map of…"),
                                   QString::fromStdString(folder.parent_path().string()));
    choice->setObjectName(QStringLiteral("mergeWith"));
    choice->setAttribute(Qt::WA_DeleteOnClose);
    choice->setFileMode(QFileDialog::Directory);
    choice->setOption(QFileDialog::ShowDirsOnly);
    connect(choice, &QFileDialog::fileSelected, this, [this, folder](const QString& other) {
        std::error_code none;
        if (std::filesystem::equivalent(folder, other.toStdString(), none))
            return tell(tr("That is this mission: its map is merged with that of another one"));
        if (const auto there = hasMap(other.toStdString()); !there)
            return tell(QString::fromStdString(there.error().text));
        if (m_bridge.reporting() || m_bridge.comparison().comparing())
            return tell(
                tr("A report is being written, or scans are being registered again: merge after that"));
        emit mergingWanted(other);
    });
    choice->open();
}

void ReviewWindow::addByHand() {
    QAction& byHand = m_commands->add(
        {.id = QStringLiteral("review.mapByHand"),
         .menu = CommandMenu::Mission,
         .text = tr("Correct the map by &hand…"),
         .hint = tr("Moves parts of the map, answers where it meets itself, accepts, rejects and registers "
                    "scans again, in a window of its own; the review is opened again then. What was recorded "
                    "stays as it is, and each decision can be taken back")});
    byHand.setEnabled(false);
    connect(&byHand, &QAction::triggered, this, [this] {
        if (m_bridge.reporting() || m_bridge.comparison().comparing())
            return tell(
                tr("A report is being written, or scans are being registered again: correct the map "
                   "after that"));
        emit byHandWanted();
    });
    const bool ours = !m_bridge.player().mapsOffline() && !isOfOthers(m_bridge.player().folder());
    const auto follow = [ours, &byHand](const ReviewIndexPtr& index) {
        byHand.setEnabled(ours && !index->finished->keyScans->empty());
    };
    connect(&m_bridge, &ReviewBridge::opened, this, follow);
    if (m_bridge.index()) follow(m_bridge.index());
}

void ReviewWindow::build() {
    m_frame = new WindowFrame(*this);
    auto* name = new ElidedLabel(
        tr("REVIEW · %1").arg(QString::fromStdString(m_bridge.player().folder().filename().string())), this);
    name->setObjectName(QStringLiteral("reviewName"));
    name->setToolTip(QString::fromStdString(m_bridge.player().folder().string()));
    name->setProperty("muted", true);
    name->setMinimumWidth(std::min(LeastName, name->sizeHint().width()));
    m_frame->build({{m_robots->bar(), GivesWay::LittleByLittle},
                    {m_layouts->bar(), GivesWay::AtOnce},
                    {m_review->clock()}},
                   {{name, GivesWay::LittleByLittle}}, *m_panes, m_timeline->widget());
    m_timeline->bar().setFocus();
}

MapView& ReviewWindow::mapView() const {
    return m_map->view();
}

MapViewSettings ReviewWindow::view() const {
    MapViewSettings view = m_map->settings();
    view.look = m_layouts->ownSight().look;
    return view;
}

void ReviewWindow::setLook(MapLook look) {
    m_map->show({look, m_map->sight().follow});
}

void ReviewWindow::tell(const QString& text) {
    m_frame->tell(text);
    m_messages->add(text);
}

QString ReviewWindow::newest() const {
    return m_frame->newest();
}

QString ReviewWindow::missing() const {
    if (!m_bridge.reviewed()) return tr("the mission is still read through");
    const bool map = !m_bridge.reviewed()->map->scans.empty();
    if (map && !m_map->missing().isEmpty()) return m_map->missing().join(QStringLiteral(", "));
    for (const Event& event : m_bridge.reviewed()->pictures) {
        if (std::holds_alternative<PictureSample>(event.sample)) {
            // Cameras that sent pictures by then show them.
            const QStringList cameras = m_cameras->missing();
            if (cameras.size() == 2) return cameras.join(QStringLiteral(", "));
        }
    }
    return {};
}

void ReviewWindow::closeEvent(QCloseEvent* event) {
    emit closing();
    QMainWindow::closeEvent(event);
}

}  // namespace leitstand
