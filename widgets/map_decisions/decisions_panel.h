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

/// Lists the scans of a live map with their doubts, and offers the decisions accept, reject, retry, rewind
/// and undo. Below the list, the operator limits the map to an area.
class DecisionsPanel final : public QWidget {
    Q_OBJECT
public:
    /// Shows @p scans, which must outlive this panel.
    explicit DecisionsPanel(KeyScanModel& scans, QWidget* parent = nullptr);
    ~DecisionsPanel() override;

    /// Adds buttons for @p commands, two per row; a null leaves a gap. The buttons show the commands' short
    /// texts (iconText) and keys.
    void setDecisions(const std::vector<QAction*>& commands);
    /// Adds buttons in the same way for commands that limit the map to an area.
    void setAreaCommands(const std::vector<QAction*>& commands);

    [[nodiscard]] std::uint64_t chosen() const;  ///< KeyScanSample::id; 0: none
    void choose(std::uint64_t id);
    /// Returns the selected maximum pair distances for registering a scan again, one per stage, from large to
    /// small [m].
    [[nodiscard]] std::vector<double> retrySchedule() const;
    /// Shows the present ceiling in the map [m]: nothing above it enters the map. Empty: none.
    void setCeiling(const std::optional<double>& height);
    /// Shows @p text about the present area.
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
    void publishCeiling();

    KeyScanModel& m_scans;
    QLabel *m_title, *m_details, *m_areaText;
    QTableView* m_table;
    QComboBox* m_retry;
    QCheckBox* m_cut;
    NumberBox* m_ceiling;
    QGridLayout *m_decisions, *m_area;
    std::uint64_t m_reported = 0;
};

}  // namespace leitstand
