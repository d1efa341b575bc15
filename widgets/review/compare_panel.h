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

/// The map of a mission beside that which other settings make of its scans: the settings, the figures, and
/// which of the two is shown.
class ComparePanel final : public QWidget {
    Q_OBJECT
public:
    explicit ComparePanel(QWidget* parent = nullptr);

    /// What is set; where the distances cannot be read, their last readable value.
    [[nodiscard]] RegistrationSettings settings() const;
    void setSettings(const RegistrationSettings& settings);
    void setComparing(bool on);
    /// How far it is, 0 to 1.
    void showProgress(double fraction);
    void showResult(const MapComparison& comparison);
    void choose(ComparedMap which);  ///< which map is said to be shown
    [[nodiscard]] bool comparing() const { return m_comparing; }

    [[nodiscard]] QSize sizeHint() const override { return {420, 420}; }

signals:
    void wanted(const leitstand::RegistrationSettings& settings);
    void cancelled();
    void mapChosen(leitstand::ComparedMap which);  ///< of the newest result, by the operator

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
