#include "widgets/robots/measures_form.h"

#include <algorithm>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/base/rotation/euler_angles.h"
#include "widgets/models/others_text.h"
#include "widgets/painting/number_box.h"
#include "widgets/painting/pane_paint.h"
#include "widgets/robots/measures_drawing.h"

namespace leitstand {
namespace {

constexpr double Farthest = 10.0;  ///< as in robots' files [m]
constexpr int Narrow = 84;         ///< of a box without a unit [px]

NumberBox* metres(double low, const QString& name, QWidget* parent) {
    auto* box = new NumberBox(low, Farthest, 0.01, 3, QStringLiteral(" m"), parent);
    box->setAccessibleName(name);
    return box;
}

QLabel* caption(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(sized(label->font(), 13, true));
    return label;
}

}  // namespace

MeasuresForm::MeasuresForm(QWidget* parent) : QWidget(parent), m_drawing(new MeasuresDrawing(this)) {
    setObjectName(QStringLiteral("measures"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 10, 12, 12);
    layout->setSpacing(8);
    layout->addWidget(m_drawing, 2);
    layout->addWidget(body());
    layout->addWidget(caption(tr("Sensors in the robot's base frame"), this));
    layout->addWidget(sensors(), 1);
    auto* note =
        new QLabel(tr("Where the robot tells a place by itself (tf_static), that one counts."), this);
    note->setWordWrap(true);
    layout->addWidget(note);
    m_problem = new QLabel(this);
    m_problem->setObjectName(QStringLiteral("problem"));
    m_problem->setWordWrap(true);
    m_problem->setVisible(false);
    layout->addWidget(m_problem);
    layout->addWidget(buttons());
}

QWidget* MeasuresForm::body() {
    auto* row = new QWidget(this);
    auto* grid = new QGridLayout(row);
    grid->setContentsMargins(0, 0, 0, 0);
    const QString names[] = {tr("Ahead"), tr("Behind"), tr("Left"), tr("Right"), tr("Height")};
    const QString hints[] = {
        tr("From the base frame to the front end"), tr("From the base frame to the rear end"),
        tr("From the base frame to the left side"), tr("From the base frame to the right side"),
        tr("From the ground to the highest part")};
    for (int i = 0; i < 5; ++i) {
        const auto place = static_cast<std::size_t>(i);
        auto* box = metres(i < 4 ? -Farthest : 0.01, names[place], row);
        box->setToolTip(hints[place]);
        grid->addWidget(new QLabel(names[place], row), 0, i);
        grid->addWidget(box, 1, i);
        if (i < 4) {
            m_sides[place] = box;
            connect(box, &NumberBox::valueChanged, this, &MeasuresForm::takeSides);
        } else {
            m_height = box;
            connect(box, &NumberBox::valueChanged, this, [this](double value) {
                if (m_filling) return;
                m_measures.height = value;
                showDrawing();
            });
        }
    }
    m_outline = new QLabel(row);
    m_outline->setWordWrap(true);
    grid->addWidget(m_outline, 2, 0, 1, 5);
    return row;
}

QWidget* MeasuresForm::sensors() {
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setMinimumHeight(90);
    m_table = new QWidget(scroll);
    m_grid = new QGridLayout(m_table);
    m_grid->setContentsMargins(0, 0, 0, 0);
    scroll->setWidget(m_table);
    return scroll;
}

QWidget* MeasuresForm::buttons() {
    auto* row = new QWidget(this);
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    m_model = new QPushButton(tr("Take from its model"), row);
    m_model->setObjectName(QStringLiteral("fromModel"));
    m_save = new QPushButton(tr("Save and use"), row);
    m_save->setObjectName(QStringLiteral("save"));
    auto* close = new QPushButton(tr("Close"), row);
    connect(m_model, &QPushButton::clicked, this, &MeasuresForm::modelWanted);
    connect(m_save, &QPushButton::clicked, this, &MeasuresForm::saveWanted);
    connect(close, &QPushButton::clicked, this, &MeasuresForm::closeWanted);
    // Enter ends the writing of a number; it presses no button.
    for (QPushButton* const button : {m_model, m_save, close}) button->setAutoDefault(false);
    line->addWidget(m_model);
    line->addStretch(1);
    line->addWidget(m_save);
    line->addWidget(close);
    setModelKnown(false);
    setRefusal({});
    return row;
}

void MeasuresForm::setModelKnown(bool known) {
    m_model->setEnabled(known);
    m_model->setToolTip(
        known ? tr("Outline, height and sensor places as in the model that the robot publishes, all "
                   "joints at rest")
              : tr("The robot publishes no model (robot_description), or it was not read yet"));
}

void MeasuresForm::setRefusal(const QString& why) {
    m_save->setEnabled(why.isEmpty());
    m_save->setToolTip(
        why.isEmpty()
            ? tr("Writes the robot's file; the station opens again with it and goes on with its mission")
            : why);
}

void MeasuresForm::complain(const QString& problem) {
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
}

void MeasuresForm::setMeasures(const Measures& measures) {
    // Boxes of the same sensors stay, and keep the focus.
    const bool same = std::equal(measures.sensors.begin(), measures.sensors.end(), m_measures.sensors.begin(),
                                 m_measures.sensors.end(), [](const SensorPlace& a, const SensorPlace& b) {
                                     return a.name == b.name && a.frame == b.frame;
                                 });
    m_measures = measures;
    m_chosen.clear();
    complain({});
    if (!same || m_boxes.empty()) fillSensors();
    showNumbers();
}

void MeasuresForm::fillSensors() {
    while (QLayoutItem* const item = m_grid->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_boxes.clear();
    const QString heads[] = {{}, tr("x"), tr("y"), tr("z"), tr("roll"), tr("pitch"), tr("yaw")};
    // Units stand above: boxes that repeat them do not fit side by side.
    for (int column = 1; column < 7; ++column) {
        const QString unit = column < 4 ? QStringLiteral(" [m]") : QStringLiteral(" [°]");
        m_grid->addWidget(new QLabel(heads[column] + unit, m_table), 0, column);
    }
    int row = 1;
    for (const SensorPlace& sensor : m_measures.sensors) {
        auto* name = new QLabel(othersText(sensor.name), m_table);
        name->setToolTip(tr("Frame %1").arg(othersText(sensor.frame)));
        m_grid->addWidget(name, row, 0);
        SensorBoxes boxes{};
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const QString what = othersText(sensor.name) + QLatin1Char(' ') + heads[i + 1];
            boxes[i] = i < 3 ? new NumberBox(-Farthest, Farthest, 0.01, 3, {}, m_table)
                             : new NumberBox(-360.0, 360.0, 1.0, 2, {}, m_table);
            boxes[i]->setMinimumWidth(Narrow);
            boxes[i]->setAccessibleName(what);
            m_grid->addWidget(boxes[i], row, static_cast<int>(i) + 1);
            connect(boxes[i], &NumberBox::valueChanged, this, [this, chosen = sensor.name] {
                if (m_filling) return;
                m_chosen = chosen;
                takeSensors();
            });
        }
        m_boxes.push_back(boxes);
        ++row;
    }
    m_grid->setColumnStretch(0, 1);
    m_grid->setRowStretch(row, 1);
}

void MeasuresForm::showNumbers() {
    m_filling = true;
    const Sides sides = sidesOf(m_measures.footprint);
    const std::array<double, 4> reach = {sides.front, sides.rear, sides.left, sides.right};
    for (std::size_t i = 0; i < reach.size(); ++i) m_sides[i]->setValue(reach[i]);
    m_height->setValue(m_measures.height);
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        const Pose& pose = m_measures.sensors[i].sensorInBase;
        const Eigen::Vector3d angles = rollPitchYawOf(pose);
        for (int k = 0; k < 3; ++k) {
            m_boxes[i][static_cast<std::size_t>(k)]->setValue(pose.translation()[k]);
            m_boxes[i][static_cast<std::size_t>(k) + 3]->setValue(inDegrees(angles[k]));
        }
    }
    m_filling = false;
    m_outline->setVisible(!isRectangle(m_measures.footprint));
    m_outline->setText(tr("The outline has %1 corners; a number that is changed here makes it a rectangle.")
                           .arg(m_measures.footprint.size()));
    showDrawing();
}

void MeasuresForm::takeSides() {
    if (m_filling) return;
    m_measures.footprint =
        footprintOf({m_sides[0]->value(), m_sides[1]->value(), m_sides[2]->value(), m_sides[3]->value()});
    m_outline->setVisible(false);
    m_chosen.clear();
    showDrawing();
}

void MeasuresForm::takeSensors() {
    for (std::size_t i = 0; i < m_boxes.size(); ++i) {
        if (m_measures.sensors[i].name != m_chosen) continue;
        const SensorBoxes& boxes = m_boxes[i];
        m_measures.sensors[i].sensorInBase =
            poseFrom({boxes[0]->value(), boxes[1]->value(), boxes[2]->value()}, degrees(boxes[3]->value()),
                     degrees(boxes[4]->value()), degrees(boxes[5]->value()));
    }
    showDrawing();
}

void MeasuresForm::showDrawing() {
    m_drawing->show(m_measures, m_chosen);
}

}  // namespace leitstand
