#pragma once

#include <QWidget>

#include "core/mapping/comparison/map_comparison.h"
#include "widgets/models/review/text_table_model.h"

class QButtonGroup;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QToolButton;

namespace leitstand {

class NumberBox;

/// Compares the map of a mission with the map that other registration settings give. Has the settings, the
/// figures, and the choice of the map that is shown.
class ComparePanel final : public QWidget {
    Q_OBJECT
public:
    explicit ComparePanel(QWidget* parent = nullptr);

    /// Returns the settings. Invalid distances keep their last valid value.
    [[nodiscard]] RegistrationSettings settings() const;
    void setSettings(const RegistrationSettings& settings);
    void setComparing(bool on);
    /// Shows the progress of the comparison, 0 to 1.
    void showProgress(double fraction);
    void showResult(const MapComparison& comparison);
    void choose(ComparedMap which);  ///< marks the map that is shown
    [[nodiscard]] bool comparing() const { return m_comparing; }

    [[nodiscard]] QSize sizeHint() const override { return {420, 420}; }

signals:
    void wanted(const leitstand::RegistrationSettings& settings);
    void cancelled();
    void mapChosen(leitstand::ComparedMap which);  ///< the operator selected a map of the newest result

private:
    void addSettings(QFormLayout& form);
    QWidget* mapChoice();
    QWidget* tables();

    TextTableModel m_figures, m_scans;
    bool m_comparing = false;
    std::vector<double> m_schedule;
    QComboBox *m_minimizer, *m_reference;
    QLineEdit* m_distances;
    NumberBox* m_reduce;
    QToolButton* m_begin;
    QProgressBar* m_progress;
    QButtonGroup* m_maps;
    QLabel* m_note;
    QWidget *m_choice, *m_tables;
};

}  // namespace leitstand
