#include "app/window/panes/camera/camera_feature.h"

#include <algorithm>
#include <chrono>
#include <variant>

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>

#include "app/services/station/cameras/station_cameras.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/input/selection.h"
#include "app/window/panes/camera/camera_keys.h"
#include "app/window/panes/camera/camera_overlays.h"
#include "app/window/source/moment_source.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/models/camera/camera_text.h"
#include "widgets/models/live/texts/sight_text.h"

namespace leitstand {
namespace {

constexpr double Step = degrees(10);  ///< angle of one turning command [rad]

}  // namespace

CameraFeature::CameraFeature(const ViewContext& context)
    : QObject(&context.window),
      m_context(context),
      m_large(new CameraPane(&context.window)),
      m_small(new CameraPane(&context.window)) {
    m_large->setObjectName(QStringLiteral("cameraPane"));
    m_small->setObjectName(QStringLiteral("rightPane"));
    if (context.liveStation != nullptr) addTurning();
    addLooks();
    addInfrared();
    connect(m_large, &CameraPane::pictureClicked, this, &CameraFeature::driveWanted);
    connect(m_large, &CameraPane::pictureDragged, this, &CameraFeature::drag);
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small}) {
        connect(&pane(place), &CameraPane::pointedAt, this,
                [this, place](const QPointF& at) { point(place, at); });
        connect(&pane(place), &CameraPane::pointingEnded, this, &CameraFeature::pointingEnded);
    }
    connect(&context.selection, &Selection::changed, this, &CameraFeature::choose);
    connect(&context.source, &MomentSource::pictured, this, &CameraFeature::showPicture);
    connect(&context.source, &MomentSource::pictureGone, this, &CameraFeature::forget);
    connect(&context.source, &MomentSource::ticked, this, &CameraFeature::show);
    applyLooks();
    choose();
}

QWidget& CameraFeature::large() const {
    return *m_large;
}

QWidget& CameraFeature::small() const {
    return *m_small;
}

QAction& CameraFeature::add(const char* id, const QString& text, const QString& hint,
                            const QKeySequence& keys, bool checkable) {
    return m_context.commands.add({.id = QString::fromLatin1(id),
                                   .menu = CommandMenu::Cameras,
                                   .text = text,
                                   .hint = hint,
                                   .keys = keys,
                                   .checkable = checkable});
}

void CameraFeature::addTurning() {
    auto* keys = new CameraKeys(m_context.window,
                                [this] { return m_context.source.moment().view(robotName()).drive.focus; });
    connect(keys, &CameraKeys::rateWanted, this,
            [this](const PanTiltAngles& rate) { setRate(rate.pan, rate.tilt); });
    connect(keys, &CameraKeys::recentreWanted, this, &CameraFeature::recentre);
    connect(&add("camera.recentre", tr("Re-&centre cameras"), tr("All cameras of the robot look ahead"),
                 Qt::Key_C),
            &QAction::triggered, this, &CameraFeature::recentre);
    // CameraKeys handles held keys; the texts only name them.
    const auto turn = [this](const char* id, const QString& text, double pan, double tilt) {
        connect(
            &add(id, text, tr("Turns the large camera by 10 degrees; its keys turn it while they are held")),
            &QAction::triggered, this, [this, pan, tilt] { turnBy(pan, tilt); });
    };
    turn("camera.left", tr("Turn &left\tQ"), Step, 0.0);
    turn("camera.right", tr("Turn &right\tE"), -Step, 0.0);
    turn("camera.up", tr("Turn &up\tPgUp"), 0.0, -Step);
    turn("camera.down", tr("Turn &down\tPgDown"), 0.0, Step);
    m_context.commands.separate(CommandMenu::Cameras);
}

void CameraFeature::addLooks() {
    connect(&add("camera.next", tr("&Next small picture"),
                 tr("Shows the next camera of the robot in the small pane"), Qt::Key_I),
            &QAction::triggered, this, [this] {
                m_views.next();
                showPanes();
            });
    connect(&add("camera.exchange", tr("E&xchange both pictures"),
                 tr("The camera in the small pane gets the large one")),
            &QAction::triggered, this, [this] {
                setRate(0.0, 0.0);  // stops the camera that was large until now
                m_views.swap();
                showPanes();
            });
    connect(&add("camera.contrast", tr("Help in the d&ark"),
                 tr("More contrast in pictures: gently, strongly, not. The log keeps them as they came"),
                 Qt::Key_L),
            &QAction::triggered, this, [this] {
                m_looks.nextContrast();
                applyLooks();
            });
    QAction& unwarp =
        add("omni.unwarp", tr("Omnidirectional as &panorama"),
            tr("All around in one strip, ahead in the middle; or as the mirror shows it"), Qt::Key_U, true);
    unwarp.setChecked(m_looks.look().unwrapped);
    connect(&unwarp, &QAction::toggled, this, [this](bool on) {
        m_looks.setUnwrapped(on);
        applyLooks();
    });
    if (m_context.liveStation == nullptr) return m_context.commands.separate(CommandMenu::Cameras);
    connect(&add("camera.snapshot", tr("Keep a &snapshot"),
                 tr("The newest large picture, as it came, into the mission's folder snapshots"), Qt::Key_P),
            &QAction::triggered, this, [this] { keep(CameraPlace::Large); });
    connect(&add("camera.snapshotSmall", tr("Keep a snapshot of the s&mall picture"),
                 tr("The same of the small picture"), Qt::SHIFT | Qt::Key_P),
            &QAction::triggered, this, [this] { keep(CameraPlace::Small); });
    m_context.commands.separate(CommandMenu::Cameras);
}

void CameraFeature::addInfrared() {
    auto* palettes = new QActionGroup(this);
    const auto palette = [this, palettes](const char* id, const QString& text, ThermalPalette colours) {
        QAction& one = add(id, text, {}, {}, true);
        palettes->addAction(&one);
        one.setChecked(colours == m_looks.palette());
        connect(&one, &QAction::triggered, this, [this, colours] {
            m_looks.setPalette(colours);
            showPanes();
        });
    };
    palette("ir.iron", tr("Infrared in &iron colours"), ThermalPalette::Iron);
    palette("ir.greyHot", tr("Infrared in grey, &hot is white"), ThermalPalette::GreyHot);
    palette("ir.greyCold", tr("Infrared in grey, hot is &black"), ThermalPalette::GreyCold);
    QAction& follow = add(
        "ir.autoRange", tr("Infrared colours &follow the picture"),
        tr("From its coldest to its hottest; otherwise a colour is always the same temperature"), {}, true);
    connect(&follow, &QAction::toggled, this, [this](bool on) {
        m_looks.setAutoRange(on);
        showPanes();
    });
}

std::string CameraFeature::robotName() const {
    return m_context.selection.name().toStdString();
}

CameraTurning* CameraFeature::turning() const {
    return m_context.liveStation == nullptr ? nullptr : &m_context.liveStation->cameras().turning();
}

CameraPane& CameraFeature::pane(CameraPlace place) const {
    return place == CameraPlace::Large ? *m_large : *m_small;
}

void CameraFeature::applyLooks() {
    for (const RobotDescription& robot : m_context.selection.robots()) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role == StreamRole::Picture || stream.role == StreamRole::Thermal)
                m_context.source.pictures().setLook(robot.name, stream.sensor, m_looks.look());
        }
    }
}

void CameraFeature::choose() {
    setRate(0.0, 0.0);  // stops the camera of the robot selected before
    m_views.select(m_context.selection.robot());
    showPanes();
}

void CameraFeature::showPanes() {
    if (m_context.liveStation != nullptr)
        m_context.liveStation->selectCamera(robotName(), m_views.sensor(CameraPlace::Large));
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small}) {
        pane(place).setCamera(m_context.selection.face(), cameraTitle(m_views.stream(place)));
        pane(place).setVacant(m_views.stream(place) == nullptr);
        const ShownPicturePtr newest = m_views.newest(place);
        if (newest) {
            showIn(pane(place), newest);
        } else {
            pane(place).setPicture({});
        }
    }
    enable();
}

void CameraFeature::enable() {
    const RobotDescription* const robot = m_views.robot();
    bool anyTurns = false, large = false, heat = false, omni = false;
    if (robot != nullptr) {
        for (const auto& [sensor, description] : robot->sensors) {
            if (!description.panTilt) continue;
            anyTurns = true;
            large = large || sensor == m_views.sensor(CameraPlace::Large);
        }
        // Thermal cameras that send colours are coloured already.
        heat = std::any_of(robot->streams.begin(), robot->streams.end(), [](const StreamDescription& one) {
            return one.role == StreamRole::Thermal && one.thermal.measured;
        });
    }
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small})
        omni = omni || isOmni(m_views.newest(place).get());
    const bool second = m_views.stream(CameraPlace::Small) != nullptr;
    const std::pair<const char*, bool> commands[] = {
        {"camera.recentre", anyTurns}, {"camera.left", large},
        {"camera.right", large},       {"camera.up", large},
        {"camera.down", large},        {"camera.next", m_views.hasNext()},
        {"camera.exchange", second},   {"camera.snapshotSmall", second},
        {"omni.unwarp", omni},         {"ir.iron", heat},
        {"ir.greyHot", heat},          {"ir.greyCold", heat},
        {"ir.autoRange", heat}};
    for (const auto& [id, can] : commands) {
        if (QAction* const command = m_context.commands.find(QLatin1String(id))) command->setEnabled(can);
    }
}

void CameraFeature::showPicture(const ShownPicturePtr& picture) {
    m_views.took(picture, m_context.source.arrivalOf(*picture));
    if (picture->robot != robotName()) return;
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small}) {
        if (picture->sensor == m_views.sensor(place)) showIn(pane(place), picture);
    }
    enable();  // pictures show whether a camera is omnidirectional
}

void CameraFeature::forget(const std::string& robot, const std::string& sensor) {
    m_views.forget(robot, sensor);
    if (robot == robotName()) showPanes();
}

void CameraFeature::showIn(CameraPane& pane, const ShownPicturePtr& picture) {
    if (const auto* heat = std::get_if<ThermalPicture>(&picture->content)) {
        pane.setThermal({picture, heat}, m_looks.rangeFor(picture->robot, picture->sensor, *heat),
                        m_looks.palette());
        pane.setHeat(picture->heat);
    } else {
        pane.setPicture(imageOf(std::get<Picture>(picture->content)));
    }
    pane.setPanorama(picture->panorama);
    const RobotDescription* const robot = m_views.robot();
    pane.setFront(robot == nullptr ? std::nullopt : frontIn(*robot, *picture));
}

void CameraFeature::show(const LiveMoment& moment) {
    CameraTurning* const turns = turning();
    if (turns != nullptr) {
        if (const auto sent = turns->pulse(); !sent)
            m_context.notify(QString::fromStdString(sent.error().text));
    }
    const RobotDescription* const robot = m_views.robot();
    if (robot == nullptr) return;
    const QAction* const recentring = m_context.commands.find(QStringLiteral("camera.recentre"));
    CameraKeyNames keys;
    if (recentring != nullptr)
        keys = {CameraKeys::names(), recentring->shortcut().toString(QKeySequence::NativeText)};
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small}) {
        const bool large = place == CameraPlace::Large;
        const auto turn = turns == nullptr ? std::nullopt : turns->view(robot->name, m_views.sensor(place));
        const ShownPicturePtr picture = m_views.newest(place);
        CameraOverlay overlay =
            cameraOverlay(turn, picture.get(), m_looks.autoRange(), large ? keys : CameraKeyNames{});
        addDetections(overlay, *robot, moment, picture.get());
        if (large) addDriving(overlay, *robot, moment, picture.get());
        pane(place).setTurnable(large && turn.has_value());
        pane(place).setLimits(m_context.source.pictureLimits(robot->name, m_views.sensor(place)));
        pane(place).setAge(m_views.age(place, moment.steady),
                           large ? sightNote(moment.view(robot->name).drive) : QString());
        pane(place).setOverlay(overlay);
    }
}

void CameraFeature::turnTo(double pan, double tilt) {
    if (CameraTurning* const turns = turning())
        turns->turnTo(robotName(), m_views.sensor(CameraPlace::Large), {pan, tilt});
}

void CameraFeature::turnBy(double pan, double tilt) {
    if (CameraTurning* const turns = turning())
        turns->turnBy(robotName(), m_views.sensor(CameraPlace::Large), {pan, tilt});
}

void CameraFeature::setRate(double pan, double tilt) {
    CameraTurning* const turns = turning();
    if (m_views.robot() == nullptr || turns == nullptr) return;
    turns->setRate(m_views.robot()->name, m_views.sensor(CameraPlace::Large), {pan, tilt});
}

void CameraFeature::recentre() {
    if (CameraTurning* const turns = turning()) turns->recentre(robotName());
}

void CameraFeature::drag(const QPointF& from, const QPointF& to, bool first) {
    const ShownPicturePtr picture = m_views.newest(CameraPlace::Large);
    CameraTurning* const turns = turning();
    if (!picture || turns == nullptr) return;
    if (first) {
        const auto turn = turns->view(robotName(), m_views.sensor(CameraPlace::Large));
        m_grabbedAt = turn ? turn->now.value_or(PanTiltAngles{}) : PanTiltAngles{};
        m_grabbed = directionAt(*picture, from);
    }
    const PanTiltAngles wanted = dragged(m_grabbedAt, m_grabbed, directionAt(*picture, to));
    turnTo(wanted.pan, wanted.tilt);
}

void CameraFeature::setPointing(bool pointing) {
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small})
        pane(place).setPointing(pointing);
}

void CameraFeature::point(CameraPlace place, const QPointF& at) {
    const ShownPicturePtr picture = m_views.newest(place);
    if (!picture || m_views.robot() == nullptr) return;
    if (const auto raw = rawPlace(*m_views.robot(), *picture, at))
        return emit pointed({picture->sensor, *raw, picture->sequence});
    m_context.notify(tr("The camera sees nothing there: nothing was filed"));
}

void CameraFeature::keep(CameraPlace place) {
    SnapshotRequest request;
    request.picture = m_views.newest(place);
    if (!request.picture) {
        m_context.notify(tr("There is no picture to keep yet"));
        return;
    }
    StationCameras& cameras = m_context.liveStation->cameras();
    request.camera = cameraTitle(m_views.stream(place)).toStdString();
    const RobotState& reported = m_context.source.moment().reported(robotName());
    if (reported.odometry) request.baseInOdom = reported.odometry->sample.baseInOdom;
    if (const auto turn = cameras.turning().view(robotName(), m_views.sensor(place)))
        request.turned = turn->now;
    cameras.snapshots().take(request);
}

QStringList CameraFeature::missing() const {
    QStringList things;
    for (const CameraPlace place : {CameraPlace::Large, CameraPlace::Small}) {
        const StreamDescription* const stream = m_views.stream(place);
        if (stream != nullptr && !m_views.newest(place))
            things += tr("no picture of %1").arg(cameraTitle(stream));
    }
    return things;
}

}  // namespace leitstand
