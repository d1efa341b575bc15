#include "app/window/map/view_commands.h"

#include <QActionGroup>
#include <QMenu>
#include <QShortcut>

#include "app/window/commands/make_action.h"
#include "widgets/map_view/map_view.h"

namespace leitstand {
namespace {

QKeySequence letter(Qt::Key key) {
    return QKeySequence(Qt::CTRL | Qt::SHIFT | key);
}

/// Height clipping starts with this slice [m]: a person's height above the floor, for a scanner half a metre
/// above it.
constexpr double FirstMinHeight = -1.0, FirstMaxHeight = 1.5;

template <class T>
void addChoice(QActionGroup& group, T value, const ActionLook& look) {
    QAction* action = makeAction(look, &group);
    action->setCheckable(true);
    action->setData(static_cast<int>(value));
    group.addAction(action);
}

template <class T>
void check(const QActionGroup& group, T value) {
    for (QAction* action : group.actions())
        action->setChecked(action->data().toInt() == static_cast<int>(value));
}

template <class T>
T chosenBy(const QAction* action) {
    return static_cast<T>(action->data().toInt());
}

}  // namespace

ViewCommands::ViewCommands(ViewState& state, MapView& view, QObject* parent, Keys keys, Escape escape)
    : QObject(parent),
      m_state(state),
      m_looks(new QActionGroup(this)),
      m_colourings(new QActionGroup(this)),
      m_themes(new QActionGroup(this)) {
    addLooks();
    addColourings();
    addThemes();
    addCameras(view);
    addTools(view, escape);
    if (keys == Keys::Plain) addPlainKeys();
    if (escape == Escape::EndsMeasuring) addEscape(view);
    connect(&state, &ViewState::changed, this, &ViewCommands::showState);
    showState();
}

/// Adds plain keys. The keys that the commands have in every window stay the first.
void ViewCommands::addPlainKeys() {
    for (QAction* action : m_looks->actions() + m_cameras + QList<QAction*>{m_before, m_clip, m_measure}) {
        const QKeySequence everywhere = action->shortcut();
        action->setShortcuts({everywhere, QKeySequence(everywhere[0].key())});
    }
}

void ViewCommands::addLooks() {
    const Qt::KeyboardModifiers keys = Qt::AltModifier;
    addChoice(*m_looks, MapLook::Points,
              {"lookPoints", tr("&Points"), tr("Shows the scans' points"), QKeySequence(keys | Qt::Key_1),
               "points"});
    addChoice(*m_looks, MapLook::Voxels,
              {"lookVoxels", tr("&Voxels"), tr("Shows the map as cubes"), QKeySequence(keys | Qt::Key_2),
               "voxels"});
    addChoice(*m_looks, MapLook::Top,
              {"lookTop", tr("&Floor plan"), tr("Shows the map from above with a 1 m grid"),
               QKeySequence(keys | Qt::Key_3), "top"});
    connect(m_looks, &QActionGroup::triggered, this, [this](const QAction* action) {
        m_state.alter([action](MapViewSettings& view) { view.look = chosenBy<MapLook>(action); });
    });
}

void ViewCommands::addColourings() {
    addChoice(*m_colourings, MapColouring::Label,
              {"colourLabel", tr("Colour by &label"), tr("Floor blue, wall yellow, ceiling red"),
               QKeySequence(Qt::CTRL | Qt::Key_1)});
    addChoice(*m_colourings, MapColouring::Scan,
              {"colourScan", tr("Colour by &scan"), tr("A colour for each scan: shows how well they fit"),
               QKeySequence(Qt::CTRL | Qt::Key_2)});
    addChoice(*m_colourings, MapColouring::Height,
              {"colourHeight", tr("Colour by &height"), {}, QKeySequence(Qt::CTRL | Qt::Key_3)});
    addChoice(*m_colourings, MapColouring::Range,
              {"colourRange", tr("Colour by &range"), tr("Distance from the scanner"),
               QKeySequence(Qt::CTRL | Qt::Key_4)});
    addChoice(*m_colourings, MapColouring::Robot,
              {"colourRobot", tr("Colour by r&obot"), tr("Which robot's scanner saw it"),
               QKeySequence(Qt::CTRL | Qt::Key_5)});
    addChoice(*m_colourings, MapColouring::Intensity,
              {"colourIntensity", tr("Colour by &intensity"),
               tr("How strongly surfaces throw the laser back"), QKeySequence(Qt::CTRL | Qt::Key_6)});
    addChoice(*m_colourings, MapColouring::Age,
              {"colourAge", tr("Colour by a&ge"), tr("When it came into the map: what is bright is new"),
               QKeySequence(Qt::CTRL | Qt::Key_7)});
    connect(m_colourings, &QActionGroup::triggered, this, [this](const QAction* action) {
        m_state.alter([action](MapViewSettings& view) { view.colouring = chosenBy<MapColouring>(action); });
    });
}

void ViewCommands::addThemes() {
    addChoice(*m_themes, Theme::Dark, {"themeDark", tr("&Dark theme"), {}, {}});
    addChoice(*m_themes, Theme::Light, {"themeLight", tr("L&ight theme"), tr("For sunlit places"), {}});
    connect(m_themes, &QActionGroup::triggered, this, [this](const QAction* action) {
        m_state.alter([action](MapViewSettings& view) { view.theme = chosenBy<Theme>(action); });
    });
}

void ViewCommands::addCameras(MapView& view) {
    const auto add = [&](CameraPreset preset, const ActionLook& look) {
        QAction* action = makeAction(look, this);
        connect(action, &QAction::triggered, &view, [&view, preset] { view.setCamera(preset); });
        m_cameras.append(action);
    };
    add(CameraPreset::Reset,
        {"cameraReset", tr("R&eset camera"), tr("Shows the whole map"), letter(Qt::Key_R), "reset"});
    add(CameraPreset::Top, {"cameraTop", tr("Camera from &above"), {}, letter(Qt::Key_T)});
    add(CameraPreset::Side, {"cameraSide", tr("Camera from the s&ide"), {}, letter(Qt::Key_Y)});
}

void ViewCommands::addTools(MapView& view, Escape escape) {
    m_before = makeAction({"before", tr("&Before registration"),
                           tr("Shows the scans where they were expected before registration"),
                           letter(Qt::Key_B), "poses", true},
                          this);
    connect(m_before, &QAction::toggled, this, [this](bool on) {
        m_state.alter([on](MapViewSettings& settings) {
            settings.poses = on ? MapPoses::Guess : MapPoses::Registered;
        });
    });
    m_clip =
        makeAction({"clip", tr("Clip by hei&ght"), tr("Shows only a slice of the map, between two heights"),
                    letter(Qt::Key_H), "height", true},
                   this);
    connect(m_clip, &QAction::toggled, this, &ViewCommands::setClipping);
    const QString measuring = escape == Escape::EndsMeasuring
                                  ? tr("Click two points for their distance; Esc ends it")
                                  : tr("Click two points for their distance; the same key again ends it");
    m_measure = makeAction({"measure", tr("&Measure"), measuring, letter(Qt::Key_M), "measure", true}, this);
    connect(m_measure, &QAction::toggled, &view, &MapView::setMeasuring);
}

void ViewCommands::addEscape(MapView& view) {
    auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), view.window());
    escape->setEnabled(false);
    connect(m_measure, &QAction::toggled, escape, &QShortcut::setEnabled);
    connect(escape, &QShortcut::activated, m_measure, [this] { m_measure->setChecked(false); });
}

void ViewCommands::fill(QMenu& menu) {
    menu.addActions(m_looks->actions());
    menu.addSeparator();
    menu.addActions(m_colourings->actions());
    menu.addSeparator();
    menu.addActions({m_before, m_clip, m_measure});
    menu.addSeparator();
    menu.addActions(m_cameras);
    menu.addSeparator();
    menu.addActions(m_themes->actions());
}

QList<QAction*> ViewCommands::tools() const {
    return m_looks->actions() +
           QList<QAction*>{nullptr, m_clip, m_measure, m_before, nullptr, m_cameras.front()};
}

void ViewCommands::setScans(int scans) {
    if (scans == 0) {
        m_before->setChecked(false);
        m_measure->setChecked(false);
    }
    m_before->setEnabled(scans > 0);
    m_measure->setEnabled(scans > 0);
}

void ViewCommands::showState() {
    const MapViewSettings& view = m_state.settings();
    check(*m_looks, view.look);
    check(*m_colourings, view.colouring);
    check(*m_themes, view.theme);
    m_before->setChecked(view.poses == MapPoses::Guess);
    m_clip->setChecked(view.minHeight.has_value() || view.maxHeight.has_value());
}

void ViewCommands::setClipping(bool on) {
    const MapViewSettings& now = m_state.settings();
    if (on == (now.minHeight.has_value() || now.maxHeight.has_value())) return;
    m_state.alter([on](MapViewSettings& view) {
        view.minHeight = on ? std::optional(FirstMinHeight) : std::nullopt;
        view.maxHeight = on ? std::optional(FirstMaxHeight) : std::nullopt;
    });
}

}  // namespace leitstand
