#include "widgets/models/live/robots/stream_table.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

constexpr double Noticeable = 0.02;  ///< smaller loss is not shown loud

struct StreamTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::StreamTable)
};

QString hz(double rate) {
    return numberText(rate, rate < 9.95 ? 1 : 0);
}

bool isSameStream(const StreamRow& one, const StreamRow& other) {
    return one.face == other.face && one.stream.topic == other.stream.topic;
}

QString columnTitle(StreamTable::Column column) {
    switch (column) {
        case StreamTable::Name:
            return StreamTexts::tr("Stream");
        case StreamTable::Type:
            return StreamTexts::tr("Type");
        case StreamTable::Rate:
            return StreamTexts::tr("Rate Hz");
        case StreamTable::Age:
            return StreamTexts::tr("Age");
        case StreamTable::Load:
            return StreamTexts::tr("kbit/s");
        case StreamTable::Loss:
            return StreamTexts::tr("Loss");
        case StreamTable::Setting:
            return StreamTexts::tr("Setting");
        case StreamTable::ColumnCount:
            break;
    }
    return {};
}

QString columnHint(StreamTable::Column column) {
    switch (column) {
        case StreamTable::Rate:
            return StreamTexts::tr("Samples a second as they come, and as the robot makes them");
        case StreamTable::Load:
            return StreamTexts::tr("What the stream takes of the link, without what is sent again");
        case StreamTable::Age:
            return StreamTexts::tr("Since the newest sample arrived");
        case StreamTable::Loss:
            return StreamTexts::tr("Samples of the last 10 s that never arrived");
        case StreamTable::Setting:
            return StreamTexts::tr("What the station asks of the stream; nothing: as the robot likes");
        case StreamTable::Name:
        case StreamTable::Type:
        case StreamTable::ColumnCount:
            break;
    }
    return {};
}

}  // namespace

QString streamNameText(const StreamRow& row) {
    QString name = streamText(row.stream.role, row.stream.sensor);
    if (row.mayMap && !row.stream.sensor.empty()) name += QChar(' ') + othersText(row.stream.sensor);
    return QStringLiteral("%1  %2").arg(row.face.letter,
                                        row.maps ? StreamTexts::tr("%1 (map)").arg(name) : name);
}

QString streamRateText(const StreamStatus& stream) {
    if (stream.paused) return StreamTexts::tr("off");
    if (stream.samples == 0) return QStringLiteral("–");
    if (!stream.steady) return StreamTexts::tr("on change");
    if (stream.expectedRate <= 0.0) return hz(stream.rate);
    return QStringLiteral("%1 / %2").arg(hz(stream.rate), hz(stream.expectedRate));
}

QString requestText(const StreamRequest& requested) {
    if (!requested.enabled) return StreamTexts::tr("off");
    QStringList parts;
    if (requested.rate > 0.0)
        parts += StreamTexts::tr("%1 Hz").arg(
            numberText(requested.rate, std::fmod(requested.rate, 1.0) > 0.0 ? 1 : 0));
    if (requested.quality > 0) parts += StreamTexts::tr("quality %1").arg(requested.quality);
    if (requested.maxWidth > 0) parts += StreamTexts::tr("%1 px").arg(requested.maxWidth);
    return parts.join(QStringLiteral(", "));
}

QString settingText(const StreamRow& row) {
    QString text = requestText(row.effective);
    if (row.effective != row.own) text = StreamTexts::tr("thin: %1").arg(text);
    // Rates are judged over some seconds, so a new request is not fulfilled yet.
    if (!isFollowed(row.effective, row.stream)) text += StreamTexts::tr(" · not yet");
    return text;
}

Tone toneOf(const StreamRow& row) {
    if (row.stream.stale || row.stream.lossRatio > Noticeable) return Tone::Attention;
    const bool silent = row.stream.paused || row.stream.samples == 0;
    return silent ? Tone::Muted : Tone::Normal;
}

QString linkTotalText(double megabits, bool thin, double budget) {
    if (thin) return StreamTexts::tr("%1 of %2 Mbit/s").arg(numberText(megabits, 1), numberText(budget, 1));
    return StreamTexts::tr("%1 Mbit/s").arg(numberText(megabits, 1));
}

void StreamTable::setRows(std::vector<StreamRow> rows) {
    const bool same = std::equal(rows.begin(), rows.end(), m_rows.begin(), m_rows.end(), isSameStream);
    if (!same) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
        return;
    }
    m_rows = std::move(rows);
    if (!m_rows.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

const StreamRow* StreamTable::row(int number) const {
    return number < 0 || number >= rowCount() ? nullptr : &m_rows[static_cast<std::size_t>(number)];
}

int StreamTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int StreamTable::columnCount(const QModelIndex& parent) const {
    if (parent.isValid()) return 0;
    return m_of == Of::Link ? ColumnCount : Load;
}

QString StreamTable::text(const StreamRow& row, Column column) {
    const StreamStatus& stream = row.stream;
    switch (column) {
        case Name:
            return streamNameText(row);
        case Type:
            return row.type;
        case Rate:
            return streamRateText(stream);
        case Load:
            return stream.samples == 0 ? QStringLiteral("–") : numberText(1e3 * stream.megabitsPerSecond, 0);
        case Age:
            return stream.samples == 0 ? QStringLiteral("–") : secondsText(stream.age);
        case Loss:
            return stream.samples == 0 ? QStringLiteral("–") : percentText(stream.lossRatio);
        case Setting:
            return settingText(row);
        case ColumnCount:
            break;
    }
    return {};
}

QVariant StreamTable::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const StreamRow& row = m_rows[static_cast<std::size_t>(index.row())];
    const auto column = Column(index.column());
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::ToolTipRole:
            return othersText(row.stream.topic);
        case Qt::TextAlignmentRole: {
            const bool number = column >= Rate && column <= Loss;
            return QVariant::fromValue(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft));
        }
        case ToneRole: {
            const bool figure = column == Rate || column == Age || column == Loss;
            const Tone tone = toneOf(row);
            return static_cast<int>(figure || tone == Tone::Muted ? tone : Tone::Normal);
        }
        default:
            return {};
    }
}

QVariant StreamTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    const auto column = Column(section);
    switch (role) {
        case Qt::DisplayRole:
            return columnTitle(column);
        case Qt::ToolTipRole:
            return columnHint(column);
        case Qt::TextAlignmentRole: {
            const bool number = column >= Rate && column <= Loss;
            return QVariant::fromValue(Qt::AlignVCenter | (number ? Qt::AlignRight : Qt::AlignLeft));
        }
        default:
            return {};
    }
}

}  // namespace leitstand
