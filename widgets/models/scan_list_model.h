#pragma once

#include <vector>

#include <QAbstractTableModel>

#include "core/mapping/map.h"

namespace leitstand {

/// The scans of a map, one row each, with a box that shows or hides the scan. Ticks stay with their rows
/// while the map grows or is registered again.
class ScanListModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// Floor, Wall and Ceiling are shares of the labelled points.
    enum Column {
        Name,
        Position,
        Heading,
        Points,
        Floor,
        Wall,
        Ceiling,
        Iterations,
        Rms,
        Overlap,
        Certainty,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows @p map, which must not be null.
    void setMap(MapPtr map);
    [[nodiscard]] const MapPtr& map() const { return m_map; }
    /// Which scans are ticked, one entry per row.
    [[nodiscard]] const std::vector<bool>& visible() const { return m_visible; }
    /// Ticks or unticks all scans.
    void setAllVisible(bool visible);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

signals:
    /// The operator ticked or unticked scans.
    void visibilityChanged(const std::vector<bool>& visible);

private:
    MapPtr m_map = std::make_shared<const Map>();
    std::vector<bool> m_visible;
};

}  // namespace leitstand
