#include "widgets/models/changes/changed_model.h"

#include <algorithm>
#include <string>

#include "widgets/models/map/nearest_row.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {
namespace {

QString missionText(const std::string& name) {
    return name.empty() ? ChangedModel::tr("now") : othersText(QString::fromStdString(name));
}

}  // namespace

std::vector<ChangedRow> changedRows(const MapChanges& changes, const std::optional<Pose>& robotInMap) {
    std::vector<ChangedRow> rows;
    for (const ChangedThing& thing : changes.things) {
        ChangedRow row;
        row.number = static_cast<int>(rows.size()) + 1;
        row.what = thing.isNew ? ChangedModel::tr("new") : ChangedModel::tr("gone");
        const Eigen::Vector3d size = thing.box.sizes();
        row.size = ChangedModel::tr("%1 × %2 × %3 m")
                       .arg(numberText(size.x(), 1), numberText(size.y(), 1), numberText(size.z(), 1));
        row.inMap = thing.box.center();
        row.place =
            ChangedModel::tr("x %1, y %2").arg(numberText(row.inMap.x(), 1), numberText(row.inMap.y(), 1));
        if (robotInMap) row.where = whereText(*robotInMap, row.inMap);
        rows.push_back(std::move(row));
    }
    return rows;
}

QString changedText(const MapChanges* changes) {
    if (changes == nullptr || changes->compared == 0) return {};
    QStringList earlier;
    for (const std::string& name : changes->visits.earlier) earlier += missionText(name);
    const auto came = std::count_if(changes->things.begin(), changes->things.end(),
                                    [](const ChangedThing& thing) { return thing.isNew; });
    return ChangedModel::tr("%1 → %2: new %3, gone %4")
        .arg(earlier.join(QStringLiteral(", ")), missionText(changes->visits.name), QString::number(came),
             QString::number(static_cast<qlonglong>(changes->things.size()) - came));
}

QString unchangedText(const MapChanges* changes) {
    if (changes == nullptr) return ChangedModel::tr("What changed is being looked for");
    if (changes->visits.after.empty())
        return ChangedModel::tr("The map is of one mission alone: there is nothing to compare it with");
    if (changes->compared == 0)
        return ChangedModel::tr("The maps of the missions have not met yet: nothing can be compared");
    return ChangedModel::tr("Where both looked, nothing changed");
}

void ChangedModel::setRows(const std::vector<ChangedRow>& rows) {
    replace(m_rows, rows, [](const ChangedRow&, const ChangedRow&) { return true; });
}

const ChangedRow* ChangedModel::row(int row) const {
    return row < 0 || row >= rowCount() ? nullptr : &m_rows[static_cast<std::size_t>(row)];
}

int ChangedModel::rowAt(const Eigen::Vector3d& place, double reach) const {
    return nearestRow(m_rows, place, reach);
}

QString ChangedModel::hint(int row) const {
    const ChangedRow& shown = m_rows[static_cast<std::size_t>(row)];
    return QStringLiteral("%1 · %2 · %3 · %4 · %5")
        .arg(shown.number)
        .arg(shown.what, shown.size, shown.where, shown.place);
}

QString ChangedModel::cell(int row, int column) const {
    const ChangedRow& shown = m_rows[static_cast<std::size_t>(row)];
    return QStringList{QString::number(shown.number), shown.what, shown.size, shown.where, shown.place}.value(
        column);
}

QStringList ChangedModel::headers() const {
    return {tr("No."), tr("What"), tr("Size"), tr("Where"), tr("In the map")};
}

}  // namespace leitstand
