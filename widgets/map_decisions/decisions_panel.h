#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <QWidget>

class QAction;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QTableView;

namespace leitstand {

class KeyScanModel;
class NumberBox;

/// The scans of a map that grows, what speaks against them, and what can be decided: accept, reject, retry,
/// rewind, undo; below, what of the world belongs into the map.
class DecisionsPanel final : public QWidget {
    Q_OBJECT
public:
    /// Shows @p scans, which must outlive it.
    explicit DecisionsPanel(KeyScanModel& scans, QWidget* parent = nullptr);
    ~DecisionsPanel() override;

    /// Buttons for these commands, two a row; a null leaves room. They show the commands' short texts
    /// (iconText) and keys.
    void setDecisions(const std::vector<QAction*>& commands);
    /// Likewise beside what belongs into the map.
    void setAreaCommands(const std::vector<QAction*>& commands);

    [[nodiscard]] std::uint64_t chosen() const;  ///< KeyScanSample::id; 0: none
    void choose(std::uint64_t id);
    /// How far pairs may be apart when a scan is tried again: schedule [m].
    [[nodiscard]] std::vector<double> retrySchedule() const;
    /// Shows the ceiling in force, map frame [m]; empty: none.
    void setCeiling(const std::optional<double>& height);
    /// What is said of the area in force.
    void setAreaText(const QString& text);

signals:
    void chosenChanged(std::uint64_t id);
    void ceilingWanted(const std::optional<double>& height);

private:
    [[nodiscard]] QTableView* table();
    [[nodiscard]] QWidget* retryLine();
    [[nodiscard]] QWidget* worldLine();
    void addButtons(QGridLayout& grid, const std::vector<QAction*>& commands);
    void showChosen();
    void tellCeiling();

    KeyScanModel& m_scans;
    QLabel *m_title, *m_details, *m_areaText;
    QTableView* m_table;
    QComboBox* m_retry;
    QCheckBox* m_cut;
    NumberBox* m_ceiling;
    QGridLayout *m_decisions, *m_area;
    std::uint64_t m_told = 0;
};

}  // namespace leitstand
