#include "widgets/models/live/readings/reading_rows.h"

#include <cmath>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/robot_state.h"
#include "widgets/models/live/readings/reading_text.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr double AgeFrom = 5.0;  ///< ages from this are shown: slow sensors send every few seconds [s]

Tone toneOf(ReadingLevel level) {
    if (level == ReadingLevel::Act) return Tone::Act;
    return level == ReadingLevel::Attention ? Tone::Attention : Tone::Normal;
}

QString capitalised(QString text) {
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    return text;
}

QString hintOf(const ReadingRow& row, const ReadingDescription& reading) {
    QStringList lines = {row.title, othersText(row.topic), othersText(reading.field)};
    const QString looks = rangeText(reading.limits.low, reading.limits.high);
    const QString acts = rangeText(reading.limits.lowAct, reading.limits.highAct);
    if (!looks.isEmpty()) lines += ReadingRowsModel::tr("Amber outside %1").arg(looks);
    if (!acts.isEmpty()) lines += ReadingRowsModel::tr("Red outside %1").arg(acts);
    return lines.join(QLatin1Char('\n'));
}

}  // namespace

std::vector<ReadingRow> readingRows(const RobotDescription& robot, const RobotState& reported, Time now) {
    std::vector<ReadingRow> rows;
    for (const StreamDescription& stream : robot.streams) {
        const auto found = reported.readings.find(stream.topic);
        const auto* const latest = found == reported.readings.end() ? nullptr : found->second.get();
        for (std::size_t i = 0; i < stream.readings.size(); ++i) {
            const ReadingDescription& reading = stream.readings[i];
            const bool came = latest != nullptr && i < latest->sample.values.size();
            const double value = came ? latest->sample.values[i] : Unknown;
            ReadingRow row{stream.topic,
                           i,
                           capitalised(readingTitle(reading.title)),
                           readingText(value, reading.unit, reading.decimals),
                           limitsText(reading.limits),
                           {},
                           {},
                           toneOf(levelOf(reading.limits, value))};
            const double age = came ? secondsBetween(latest->received, now) : 0.0;
            if (age >= AgeFrom) row.age = secondsText(std::floor(age));
            if (!came || (age >= AgeFrom && row.tone == Tone::Normal)) row.tone = Tone::Muted;
            row.hint = hintOf(row, reading);
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

void ReadingRowsModel::show(const std::vector<ReadingRow>& rows) {
    replace(m_rows, rows, [](const ReadingRow& a, const ReadingRow& b) {
        return a.topic == b.topic && a.index == b.index;
    });
}

QStringList ReadingRowsModel::headers() const {
    return {tr("Reading"), tr("Value"), tr("Limits"), tr("Age")};
}

QString ReadingRowsModel::cell(int row, int column) const {
    const ReadingRow& one = m_rows[static_cast<std::size_t>(row)];
    switch (column) {
        case Title:
            return one.title;
        case Value:
            return one.value;
        case Limits:
            return one.limits;
        default:
            return one.age;
    }
}

QString ReadingRowsModel::hint(int row) const {
    return m_rows[static_cast<std::size_t>(row)].hint;
}

Tone ReadingRowsModel::tone(int row, int column) const {
    const Tone tone = m_rows[static_cast<std::size_t>(row)].tone;
    return column == Value || column == Title ? tone : Tone::Muted;
}

}  // namespace leitstand
