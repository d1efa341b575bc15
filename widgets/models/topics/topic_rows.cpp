#include "widgets/models/topics/topic_rows.h"

#include <algorithm>

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::TopicWords)
};

constexpr double Seconds = 2.0;  ///< ages from this are given in seconds

/// The last part of a path: "x" of "pose.position.x", "[3]" of "points[3]".
QString lastPart(const QString& path) {
    if (path.endsWith(QLatin1Char(']'))) return path.mid(path.lastIndexOf(QLatin1Char('[')));
    return path.mid(path.lastIndexOf(QLatin1Char('.')) + 1);
}

}  // namespace

std::vector<TopicRow> filtered(const std::vector<TopicRow>& rows, const QString& filter) {
    const QStringList words = filter.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    std::vector<TopicRow> kept;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(kept), [&](const TopicRow& row) {
        const QString all = row.topic + QLatin1Char(' ') + row.type + QLatin1Char(' ') + row.nodes;
        return std::all_of(words.begin(), words.end(),
                           [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
    });
    return kept;
}

void TopicRowsModel::show(const std::vector<TopicRow>& rows) {
    replace(m_rows, rows, [](const TopicRow& a, const TopicRow& b) { return a.topic == b.topic; });
}

QStringList TopicRowsModel::headers() const {
    return {tr("Topic"), tr("Type"), tr("Nodes")};
}

QString TopicRowsModel::cell(int row, int column) const {
    const TopicRow& one = m_rows[static_cast<std::size_t>(row)];
    return column == Topic ? one.topic : column == Type ? one.type : one.nodes;
}

QString TopicRowsModel::hint(int row) const {
    const TopicRow& one = m_rows[static_cast<std::size_t>(row)];
    QStringList lines = {one.topic, one.type};
    if (!one.nodes.isEmpty()) lines += one.nodes;
    if (!one.written) lines += tr("Nobody publishes it");
    if (!one.obstacle.isEmpty()) lines += one.obstacle;
    return lines.join(QLatin1Char('\n'));
}

Tone TopicRowsModel::tone(int row, int /*column*/) const {
    const TopicRow& one = m_rows[static_cast<std::size_t>(row)];
    if (!one.obstacle.isEmpty()) return Tone::Attention;
    return one.written ? Tone::Normal : Tone::Muted;
}

void FieldRowsModel::show(const std::vector<FieldRow>& rows) {
    replace(m_rows, rows, [](const FieldRow& a, const FieldRow& b) { return a.path == b.path; });
}

QStringList FieldRowsModel::headers() const {
    return {tr("Field"), tr("Value")};
}

QString FieldRowsModel::cell(int row, int column) const {
    const FieldRow& one = m_rows[static_cast<std::size_t>(row)];
    if (column == Value) return one.value;
    return QString(qsizetype{2} * one.depth, QLatin1Char(' ')) + lastPart(one.path);
}

QString FieldRowsModel::hint(int row) const {
    const FieldRow& one = m_rows[static_cast<std::size_t>(row)];
    return one.number ? tr("%1\nA click plots it").arg(one.path) : one.path;
}

QString topicSummary(double rate, double megabits, std::optional<double> age) {
    if (!age) return Words::tr("Nothing came yet");
    const QString ago = *age < Seconds ? Words::tr("%1 ms ago").arg(1e3 * *age, 0, 'f', 0)
                                       : Words::tr("%1 s ago").arg(*age, 0, 'f', 0);
    return Words::tr("%1 Hz · %2 Mbit/s · %3").arg(rate, 0, 'f', 1).arg(megabits, 0, 'f', 3).arg(ago);
}

}  // namespace leitstand
