#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include <QAbstractTableModel>

#include "core/mapping/live/map/live_map.h"
#include "widgets/models/live/robots/robot_face.h"

namespace leitstand {

/// The key scans of a live map, newest first: whether each is certain, and the doubts about it.
class KeyScanModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { Name, Trust, Doubts, Overlap, Entered, ColumnCount };

    using QAbstractTableModel::QAbstractTableModel;

    /// Sets the robots, whose letters name the scans.
    void setRobots(const std::vector<RobotFace>& robots);
    void setScans(LiveMapPtr scans);
    [[nodiscard]] const LiveMap& scans() const { return *m_scans; }
    /// Returns the scan in @p row; null: there is none.
    [[nodiscard]] const LiveKeyScan* scanAt(int row) const;
    [[nodiscard]] int rowOf(std::uint64_t id) const;  ///< -1: there is none
    /// Returns the id of the newest scan that waits for a decision; 0: none.
    [[nodiscard]] std::uint64_t newestUncertain() const;
    /// Returns the id of the next scan to decide about: the next older one that waits for a decision. After
    /// the oldest, or if the scan @p id does not wait, returns the newest waiting one. 0: none waits.
    [[nodiscard]] std::uint64_t uncertainBefore(std::uint64_t id) const;
    /// Returns how many scans wait for a decision.
    [[nodiscard]] int uncertain() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const LiveKeyScan& scan, int column) const;

    LiveMapPtr m_scans = std::make_shared<const LiveMap>();
    std::map<std::string, QString> m_letters;  ///< by robot
};

/// Returns all details of @p scan, in lines.
[[nodiscard]] QString keyScanDetails(const LiveKeyScan& scan);

/// Returns a summary of the scans on one line: "12 key scans · 2 for you to decide".
[[nodiscard]] QString keyScanSummary(const KeyScanModel& model);

}  // namespace leitstand
