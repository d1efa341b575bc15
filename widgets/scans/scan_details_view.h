#pragma once

#include <QWidget>

class QGridLayout;

namespace leitstand {

struct MapScan;

/// Shows captions and values of one scan, one line each.
class ScanDetailsView final : public QWidget {
    Q_OBJECT
public:
    explicit ScanDetailsView(QWidget* parent = nullptr);

    /// Shows @p scan; null: nothing. Keeps no reference to it.
    void setScan(const MapScan* scan);

private:
    QGridLayout* m_lines;
};

}  // namespace leitstand
