#pragma once

#include <vector>

#include <QAbstractListModel>

#include "widgets/models/live/texts/alarm_text.h"

namespace leitstand {

/// The alarms as a list, newest first. The selection is kept as long as the list has the same alarms, even if
/// numbers in their texts change.
class AlarmListModel final : public QAbstractListModel {
    Q_OBJECT
public:
    enum Role { LineRole = Qt::UserRole + 10 };  ///< returns an AlarmLine, for painters

    using QAbstractListModel::QAbstractListModel;

    void setLines(const std::vector<AlarmLine>& lines);
    [[nodiscard]] const AlarmLine* line(int row) const;  ///< null: there is none

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    std::vector<AlarmLine> m_lines;
};

}  // namespace leitstand

Q_DECLARE_METATYPE(leitstand::AlarmLine)
Q_DECLARE_METATYPE(leitstand::AlarmId)
