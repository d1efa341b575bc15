#include "app/window/robots/measures_feature.h"

#include <algorithm>

#include <QAction>
#include <QDialog>
#include <QMainWindow>
#include <QVBoxLayout>

#include "app/services/models/saved_measures.h"
#include "app/services/station/station.h"
#include "app/window/commands/command_table.h"
#include "app/window/frame/over_panes.h"
#include "app/window/input/selection.h"
#include "app/window/source/moment_source.h"
#include "core/robot/footprint.h"
#include "widgets/robots/measures_form.h"

namespace leitstand {

MeasuresFeature::MeasuresFeature(const LiveContext& context)
    : QObject(&context.window),
      m_context(context),
      m_dialog(new QDialog(&context.window)),
      m_form(new MeasuresForm(m_dialog)),
      m_bodies([](const std::string&) {}) {  // the map tells what is missing
    QAction& opens = context.commands.add(
        {.id = QStringLiteral("robot.measures"),
         .menu = CommandMenu::Robot,
         .text = tr("Si&ze and sensors..."),
         .hint = tr(
             "How large the selected robot is and where its sensors sit, with a drawing; from its model, or "
             "measured")});
    connect(&opens, &QAction::triggered, this, &MeasuresFeature::open);
    auto* layout = new QVBoxLayout(m_dialog);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_form);
    m_dialog->resize(760, 620);
    connect(m_form, &MeasuresForm::closeWanted, m_dialog, &QDialog::hide);
    connect(m_form, &MeasuresForm::modelWanted, this, &MeasuresFeature::takeModel);
    connect(m_form, &MeasuresForm::saveWanted, this, &MeasuresFeature::save);
    connect(&context.source, &MomentSource::ticked, this, &MeasuresFeature::show);
}

void MeasuresFeature::open() {
    const RobotDescription* const robot = m_context.selection.find(m_context.selection.name());
    if (robot == nullptr) return;
    if (m_dialog->isVisible() && m_robot == robot->name) return m_dialog->raise();  // its numbers stay
    m_robot = robot->name;
    m_body.reset();
    m_dialog->setWindowTitle(tr("Size and sensors of %1").arg(m_context.selection.faceOfRobot(*robot).title));
    m_form->setMeasures(measuresOf(*robot));
    m_form->setModelKnown(false);
    showOverPanes(*m_dialog, m_context.panes);
}

void MeasuresFeature::show(const LiveMoment& moment) {
    if (!m_dialog->isVisible()) return;
    const RobotDescription* const robot = m_context.selection.find(QString::fromStdString(m_robot));
    if (robot == nullptr) return;
    m_body = m_bodies.body(*robot, moment.reported(m_robot).model);
    m_form->setModelKnown(m_body != nullptr);
    const bool driven = std::any_of(moment.robots.begin(), moment.robots.end(),
                                    [](const auto& one) { return one.second.drive.driving; });
    m_form->setRefusal(driven ? tr("A robot is being driven: the station would open again") : QString());
}

void MeasuresFeature::takeModel() {
    if (!m_body) return;
    std::string problem;
    m_form->setMeasures(withModel(m_form->measures(), *m_body, problem));
    m_form->complain(QString::fromStdString(problem));
}

void MeasuresFeature::save() {
    const RobotDescription* const robot = m_context.selection.find(QString::fromStdString(m_robot));
    if (robot == nullptr) return;
    const Measures& entered = m_form->measures();
    const Measures before = measuresOf(*robot);
    RobotMeasures changed{entered.footprint, entered.height, {}};
    for (std::size_t i = 0; i < entered.sensors.size(); ++i) {
        if (!entered.sensors[i].sensorInBase.isApprox(before.sensors.at(i).sensorInBase, 1e-9))
            changed.sensorsInBase[entered.sensors[i].name] = entered.sensors[i].sensorInBase;
    }
    const auto file = saveMeasures(*robot, changed);
    if (!file) return m_form->complain(QString::fromStdString(file.error().text));
    m_dialog->hide();
    emit fileChanged(QString::fromStdString(m_robot), QString::fromStdString(*file));
}

}  // namespace leitstand
