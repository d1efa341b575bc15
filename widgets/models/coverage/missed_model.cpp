#include "widgets/models/coverage/missed_model.h"

#include "widgets/models/coverage/sensor_text.h"
#include "widgets/models/map/nearest_row.h"
#include "widgets/models/map/storey_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {

std::vector<MissedRow> missedRows(const SearchedFloor& searched, SearchSensor sensor,
                                  const std::optional<Pose>& robotInMap) {
    std::vector<MissedRow> rows;
    const bool several = searched.storeys.size() > 1;
    for (const MissedRegion& region : searched.by(sensor).missed) {
        MissedRow row;
        row.number = static_cast<int>(rows.size()) + 1;
        row.area = MissedModel::tr("%1 m²").arg(numberText(region.area, 1));
        row.inMap << region.place, region.height;
        const QString x = numberText(region.place.x(), 1), y = numberText(region.place.y(), 1);
        row.place = several ? MissedModel::tr("x %1, y %2, storey %3").arg(x, y, storeyText(region.storey))
                            : MissedModel::tr("x %1, y %2").arg(x, y);
        if (robotInMap) row.where = whereText(*robotInMap, row.inMap);
        rows.push_back(std::move(row));
    }
    return rows;
}

QString emptyText(const SearchedFloor* searched, SearchSensor sensor) {
    if (searched == nullptr) return MissedModel::tr("What was searched is not known yet");
    const double all = searched->reachable;
    if (!(all > 0.0)) return MissedModel::tr("No floor is known yet");
    if (all - searched->by(sensor).seen > 0.01) return MissedModel::tr("Only small pieces were missed");
    return MissedModel::tr("Nothing that can be reached was missed");
}

QString searchedText(const SearchedFloor& searched, SearchSensor sensor) {
    const double all = searched.reachable;
    const SearchedFloor::Part& part = searched.by(sensor);
    if (!(all > 0.0)) return MissedModel::tr("No floor is known yet");
    QString text = MissedModel::tr("%1: %2 of %3 m² seen, places missed: %4")
                       .arg(sensorText(sensor), percentText(part.seen / all), numberText(all, 1),
                            QString::number(part.missed.size()));
    for (const SearchedStorey& storey : searched.storeys) {
        if (searched.storeys.size() < 2 || !(storey.reachable > 0.0)) continue;
        const double seen = storey.seen[static_cast<std::size_t>(sensor)] / storey.reachable;
        text += MissedModel::tr("; storey %1: %2").arg(storeyText(storey.number), percentText(seen));
    }
    return text;
}

void MissedModel::setRows(const std::vector<MissedRow>& rows) {
    replace(m_rows, rows, [](const MissedRow&, const MissedRow&) { return true; });
}

const MissedRow* MissedModel::row(int row) const {
    return row < 0 || row >= rowCount() ? nullptr : &m_rows[static_cast<std::size_t>(row)];
}

int MissedModel::rowAt(const Eigen::Vector3d& place, double reach) const {
    return nearestRow(m_rows, place, reach);
}

QString MissedModel::hint(int row) const {
    const MissedRow& shown = m_rows[static_cast<std::size_t>(row)];
    return QStringLiteral("%1 · %2 · %3 · %4").arg(shown.number).arg(shown.area, shown.where, shown.place);
}

QString MissedModel::cell(int row, int column) const {
    const MissedRow& shown = m_rows[static_cast<std::size_t>(row)];
    return QStringList{QString::number(shown.number), shown.area, shown.where, shown.place}.value(column);
}

QStringList MissedModel::headers() const {
    return {tr("No."), tr("Missed"), tr("Where"), tr("In the map")};
}

}  // namespace leitstand
