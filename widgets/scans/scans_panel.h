#pragma once

#include <QWidget>

class QTableView;

namespace leitstand {

class ScanListModel;
class ScanDetailsView;

/// Lists the scans of the map with tick boxes and figures, and the details of the current one.
class ScansPanel final : public QWidget {
    Q_OBJECT
public:
    /// Shows @p scans, which must outlive this panel.
    explicit ScansPanel(ScanListModel& scans, QWidget* parent = nullptr);

private:
    void showCurrent();

    ScanListModel& m_scans;
    QTableView* m_table;
    ScanDetailsView* m_details;
};

}  // namespace leitstand
