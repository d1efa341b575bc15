#pragma once

#include <vector>

#include <QDialog>
#include <QString>

#include "core/event/station_samples.h"

class QComboBox;
class QLineEdit;
class QSpinBox;

namespace leitstand {

/// Edits the mission's data for the report, and selects the rules for its score. Not modal, since robots may
/// be driving.
class MissionForm final : public QDialog {
    Q_OBJECT
public:
    /// Names and titles of score rules.
    using Profiles = std::vector<std::pair<QString, QString>>;
    MissionForm(const MissionInfoSample& info, const Profiles& profiles, QWidget* parent = nullptr);

    /// Returns the current contents of the form.
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
