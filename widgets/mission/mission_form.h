#pragma once

#include <vector>

#include <QDialog>
#include <QString>

#include "core/event/station_samples.h"

class QComboBox;
class QLineEdit;
class QSpinBox;

namespace leitstand {

/// What the report says of the mission, and what its score is counted by. Not modal: robots may be driving.
class MissionForm final : public QDialog {
    Q_OBJECT
public:
    /// Names and titles of rules of scores.
    using Profiles = std::vector<std::pair<QString, QString>>;
    MissionForm(const MissionInfoSample& info, const Profiles& profiles, QWidget* parent = nullptr);

    /// As the form has it now.
    [[nodiscard]] MissionInfoSample info() const;

signals:
    void wanted(const leitstand::MissionInfoSample& info);

private:
    MissionInfoSample m_info;
    QLineEdit *m_competition, *m_team, *m_country, *m_mission;
    QSpinBox* m_operators;
    QComboBox *m_area, *m_profile;
};

}  // namespace leitstand
