#pragma once

#include <vector>

#include <QWidget>

#include "widgets/models/pad/pad_table.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QTableView;

namespace leitstand {

class StickGauge;

/// A pad that can be selected.
struct PadChoice {
    int id = -1;
    QString name;
};

/// Lets the operator select the gamepad that drives, and what its controls do. It has a row per action, to
/// which the next pushed control can be bound. Sliders for dead zone and curve are above bars that show the
/// sticks. It is a separate window, never modal.
class PadMappingDialog final : public QWidget {
    Q_OBJECT
public:
    explicit PadMappingDialog(QWidget* parent = nullptr);

    void setPads(const std::vector<PadChoice>& pads, int chosen);
    void setCommands(std::vector<PadCommandFace> commands) { m_table.setCommands(std::move(commands)); }
    /// Shows @p bindings. Does nothing while the operator has unsaved changes to bindings of the same
    /// PadLayout.
    void setBindings(const PadBindings& bindings);
    void setState(const PadState& state);

signals:
    void padChosen(int id);
    void saved(const leitstand::PadBindings& bindings);

protected:
    bool event(QEvent* event) override;

private:
    void buildTable();
    [[nodiscard]] QWidget* buildShape();
    [[nodiscard]] QWidget* buildButtons();
    QSlider* addSlider(QGridLayout& grid, int row, const QString& name, const QString& hint, int least,
                       int most);
    void showBindings();
    void showState();
    void readShape();
    [[nodiscard]] int row() const;

    PadTable m_table;
    QComboBox* m_pads;
    QTableView* m_view;
    QLabel* m_word;
    QSlider *m_zone = nullptr, *m_expo = nullptr, *m_press = nullptr;
    std::vector<StickGauge*> m_gauges;
    QPushButton *m_set = nullptr, *m_clear = nullptr, *m_save = nullptr, *m_reset = nullptr;
    bool m_showing = false;
};

}  // namespace leitstand
