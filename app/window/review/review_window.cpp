#include "app/window/review/review_window.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLabel>

#include "app/services/recorded/carried_map.h"
#include "app/services/recorded/review_log.h"
#include "app/window/commands/command_table.h"
#include "app/window/commands/help_commands.h"
#include "app/window/commands/language_commands.h"
#include "app/window/frame/key_columns.h"
#include "app/window/frame/pane_docks.h"
#include "app/window/frame/window_frame.h"
#include "app/window/input/selection.h"
#include "app/window/layouts/layout_feature.h"
#include "app/window/layouts/layout_switch.h"
#include "app/window/panes/camera/camera_feature.h"
#include "app/window/panes/compare/compare_feature.h"
#include "app/window/panes/finds/finds_feature.h"
#include "app/window/panes/map/map_feature.h"
#include "app/window/review/review_clock.h"
#include "app/window/review/tidying_feature.h"
#include "app/window/review/timeline_feature.h"
#include "app/window/robots/robots_feature.h"
#include "app/window/source/review_bridge.h"
#include "app/window/source/review_comparison.h"
#include "core/event/picture_samples.h"
#include "core/mission/state/scan_state.h"
#include "widgets/map_view/map_view.h"
#include "widgets/painting/elided_label.h"
#include "widgets/painting/plain_texts.h"
#include "widgets/painting/theme.h"
#include "widgets/timeline/timeline_bar.h"

namespace leitstand {
namespace {

constexpr int LeastName = 150;  ///< least width of the mission's name in the bar [px]

}  // namespace

ReviewWindow::ReviewWindow(ReviewBridge& bridge, const MapViewSettings& view, LayoutBook layouts,
                           QWidget* parent)
    : QMainWindow(parent), m_bridge(bridge) {
    keepTextsPlain();
    applyTheme(*qApp, view.theme);  // before widgets exist, which would have to be styled again
    setWindowTitle(tr("%1 – review – Leitstand")
                       .arg(QString::fromStdString(bridge.player().folder().filename().string())));
    setWindowIcon(QIcon(QStringLiteral(":/leitstand/icons/leitstand.svg")));
    m_selection = new Selection(bridge.robots(), this);
    m_commands = new CommandTable(*this);
    m_panes = new PaneDocks(this);
    const ReviewContext context{{m_bridge, *m_selection, *m_commands, *m_panes, *this}, bridge};
    // Each feature adds its commands. The layouts come last: they place the panes and bind the keys.
    m_timeline = new TimelineFeature(context);
    m_robots = new RobotsFeature(context);
    m_clock = new ReviewClock(context);
    m_features = makePanes(context, view);
    addCommands();
    auto* const tidying = new TidyingFeature(context, m_features.map->view(), this);
    connect(tidying, &TidyingFeature::wanted, this, &ReviewWindow::tidyingWanted);
    addLanguageCommands(*m_commands, [this](const QString& code) { emit languageWanted(code); });
    m_layouts = new LayoutFeature(context, std::move(layouts), *m_features.map);
    (new HelpCommands(*this, KeyColumns::review()))->fill(m_commands->menu(CommandMenu::Help));
    m_commands->adopt(CommandMenu::Help);
    build();
    connectFeatures();
    m_bridge.watch(m_selection->name().toStdString());
    m_timeline->setOwnMarks(bridge.pen().marks());
    m_bridge.showAgain();
    m_layouts->use(QStringLiteral("review"));
}

ReviewWindow::~ReviewWindow() {
    // Signals that features emit during destruction reach nobody.
    m_bridge.disconnect(this);
    for (QObject* part : children()) part->disconnect(this);
}

void ReviewWindow::connectFeatures() {
    connect(m_selection, &Selection::changed, this,
            [this] { m_bridge.watch(m_selection->name().toStdString()); });
    connect(m_features.finds, &FindsFeature::marksChanged, m_timeline, &TimelineFeature::setOwnMarks);
    connect(m_features.compare, &CompareFeature::wanted, this,
            [this] { m_layouts->use(QStringLiteral("compare")); });
    connect(&m_bridge, &MomentSource::notified, this,
            [this](const QString& text) { m_frame->showMessage(text); });
}

void ReviewWindow::addCommands() {
    m_commands->separate(CommandMenu::Mission);
    QAction& again =
        m_commands->add({.id = "review.registerAgain",
                         .menu = CommandMenu::Mission,
                         .text = tr("&Register again…"),
                         .hint = tr("Registers the mission's scans again, in a window of its own, "
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
            return showMessage(tr("That is this mission: its map is merged with that of another one"));
        if (const auto there = hasMap(other.toStdString()); !there)
            return showMessage(QString::fromStdString(there.error().text));
        if (m_bridge.reporting() || m_bridge.comparison().comparing())
            return showMessage(
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
            return showMessage(
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
                    {&m_clock->bar()}},
                   {{name, GivesWay::LittleByLittle}}, *m_panes, m_timeline->widget());
    m_timeline->bar().setFocus();
}

MapView& ReviewWindow::mapView() const {
    return m_features.map->view();
}

MapViewSettings ReviewWindow::view() const {
    MapViewSettings view = m_features.map->settings();
    view.look = m_layouts->ownSight().look;
    return view;
}

void ReviewWindow::setLook(MapLook look) {
    m_features.map->show({look, m_features.map->sight().follow});
}

void ReviewWindow::showMessage(const QString& text) {
    m_bridge.notify(text);
}

QString ReviewWindow::newest() const {
    return m_frame->newest();
}

QString ReviewWindow::missing() const {
    if (!m_bridge.reviewed()) return tr("the mission is still read through");
    const bool map = !m_bridge.reviewed()->map->scans.empty();
    if (map && !m_features.map->missing().isEmpty())
        return m_features.map->missing().join(QStringLiteral(", "));
    for (const Event& event : m_bridge.reviewed()->pictures) {
        if (event.sample.is<PictureSample>()) {
            // Cameras that sent pictures by then show them.
            const QStringList cameras = m_features.cameras->missing();
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
