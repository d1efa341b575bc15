#pragma once

#include <QWidget>

#include "core/mapping/registration_settings.h"

class QAction;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace leitstand {

class NumberBox;

/// Edits the registration settings.
class RegistrationPanel final : public QWidget {
    Q_OBJECT
public:
    /// The panel has a button for each of the two commands. @p again: registers again. @p before: shows the
    /// start poses.
    RegistrationPanel(QAction& again, QAction& before, QWidget* parent = nullptr);

    /// Shows @p settings.
    void setSettings(const RegistrationSettings& settings);
    /// Returns the settings. Invalid texts keep their last valid value.
    [[nodiscard]] const RegistrationSettings& settings() const { return m_settings; }

signals:
    /// The operator changed something.
    void settingsChanged(const leitstand::RegistrationSettings& settings);

private:
    void addMethods(QFormLayout& form);
    void addPoints(QFormLayout& form);
    void addStart(QFormLayout& form);
    QWidget* buttons(QAction& again, QAction& before);
    void takeOver();
    void showWhatApplies();

    RegistrationSettings m_settings;
    /// Whether fields are being filled: then their signals do not come from the operator.
    bool m_showing = false;
    QComboBox* m_minimizer;
    QComboBox* m_search;
    NumberBox* m_epsilon;
    QLineEdit* m_distances;
    QLabel* m_distancesWrong;
    NumberBox* m_iterations;
    NumberBox* m_reduce;
    QComboBox* m_filter;
    NumberBox* m_minRange;
    NumberBox* m_maxRange;
    QComboBox* m_guess;
    QComboBox* m_reference;
    NumberBox* m_threads;
};

}  // namespace leitstand
