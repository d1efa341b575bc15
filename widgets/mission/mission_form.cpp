#include "widgets/mission/mission_form.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLineEdit>
#include <QSpinBox>

#include "widgets/models/victims/victim_choices.h"

namespace leitstand {
namespace {

QLineEdit* line(QFormLayout& form, const QString& name, const std::string& text, const QString& tip,
                const QString& hint = {}) {
    auto* made = new QLineEdit(QString::fromStdString(text));
    made->setMaxLength(100);
    made->setPlaceholderText(hint);
    made->setAccessibleName(name);
    made->setToolTip(tip);
    form.addRow(name, made);
    return made;
}

}  // namespace

MissionForm::MissionForm(const MissionInfoSample& info, const Profiles& profiles, QWidget* parent)
    : QDialog(parent),
      m_info(info),
      m_operators(new QSpinBox),
      m_area(new QComboBox),
      m_profile(new QComboBox) {
    setObjectName(QStringLiteral("missionForm"));
    setWindowTitle(tr("Mission data"));
    setModal(false);
    auto* form = new QFormLayout(this);
    m_competition = line(*form, tr("Competition"), info.competition,
                         tr("Names of the report's files begin with it"), tr("RoboCup2026"));
    m_team = line(*form, tr("Team"), info.team, tr("As it was registered; in all lists of the report"));
    m_country = line(*form, tr("Country"), info.country, tr("Of the team; in all lists of the report"));
    m_mission = line(*form, tr("Mission"), info.mission, tr("Which run of the competition it is"),
                     tr("Preliminary1"));
    m_operators->setRange(1, 20);
    m_operators->setValue(static_cast<int>(info.operators));
    m_operators->setAccessibleName(tr("Operators"));
    m_operators->setToolTip(tr("People who drive; some rules divide the score by them"));
    form->addRow(tr("Operators"), m_operators);
    for (const VictimChoice& choice : areaChoices())
        m_area->addItem(choice.text, QString::fromStdString(choice.word));
    m_area->setCurrentIndex(std::max(0, m_area->findData(QString::fromStdString(info.area))));
    m_area->setAccessibleName(tr("Area"));
    m_area->setToolTip(tr("Of finds that say nothing else"));
    form->addRow(tr("Area"), m_area);
    for (const auto& [name, title] : profiles) m_profile->addItem(title, name);
    const int chosen = m_profile->findData(QString::fromStdString(info.profile));
    m_profile->setCurrentIndex(chosen >= 0 ? chosen : m_profile->count() - 1);
    m_profile->setAccessibleName(tr("Rules of the score"));
    m_profile->setToolTip(tr("By these the score is estimated, here and in the report"));
    form->addRow(tr("Rules of the score"), m_profile);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        emit wanted(this->info());
        accept();
    });
}

MissionInfoSample MissionForm::info() const {
    MissionInfoSample info = m_info;
    const auto text = [](const QLineEdit* from) { return from->text().trimmed().toStdString(); };
    info.competition = text(m_competition);
    info.team = text(m_team);
    info.country = text(m_country);
    info.mission = text(m_mission);
    info.operators = static_cast<std::uint32_t>(m_operators->value());
    info.area = m_area->currentData().toString().toStdString();
    info.profile = m_profile->currentData().toString().toStdString();
    return info;
}

}  // namespace leitstand
