#include "widgets/models/map/key_scan_model.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QDateTime>
#include <QLocale>

#include "core/event/scan_pose.h"
#include "widgets/models/map/doubt_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/times.h"

namespace leitstand {
namespace {

QString clockText(Time time) {
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return timeOfDayText(QDateTime::fromMSecsSinceEpoch(since.count()).time());
}

bool sameScans(const LiveMap& before, const LiveMap& after) {
    return before.scans.size() <= after.scans.size() &&
           std::equal(before.scans.begin(), before.scans.end(), after.scans.begin(),
                      [](const LiveKeyScan& a, const LiveKeyScan& b) { return a.id == b.id; });
}

}  // namespace

void KeyScanModel::setRobots(const std::vector<RobotFace>& robots) {
    m_letters.clear();
    for (const RobotFace& face : robots) m_letters[face.name.toStdString()] = face.letter;
}

void KeyScanModel::setScans(LiveMapPtr scans) {
    if (!scans || scans == m_scans) return;
    if (!sameScans(*m_scans, *scans)) {
        beginResetModel();
        m_scans = std::move(scans);
        endResetModel();
        return;
    }
    // Scans are only added, so the selection stays.
    const int before = rowCount(), more = static_cast<int>(scans->scans.size()) - before;
    if (more > 0) beginInsertRows({}, 0, more - 1);
    m_scans = std::move(scans);
    if (more > 0) endInsertRows();
    if (before > 0) emit dataChanged(index(more, 0), index(more + before - 1, ColumnCount - 1));
}

const LiveKeyScan* KeyScanModel::scanAt(int row) const {
    if (row < 0 || row >= rowCount()) return nullptr;
    return &m_scans->scans[m_scans->scans.size() - 1 - static_cast<std::size_t>(row)];
}

int KeyScanModel::rowOf(std::uint64_t id) const {
    for (int row = 0; row < rowCount(); ++row) {
        if (scanAt(row)->id == id) return row;
    }
    return -1;
}

std::uint64_t KeyScanModel::newestUncertain() const {
    for (int row = 0; row < rowCount(); ++row) {
        if (scanAt(row)->pose.trust == ScanTrust::Uncertain) return scanAt(row)->id;
    }
    return 0;
}

std::uint64_t KeyScanModel::uncertainBefore(std::uint64_t id) const {
    const LiveKeyScan* const chosen = scanAt(rowOf(id));
    if (chosen == nullptr || chosen->pose.trust != ScanTrust::Uncertain) return newestUncertain();
    for (int row = rowOf(id) + 1; row < rowCount(); ++row) {
        if (scanAt(row)->pose.trust == ScanTrust::Uncertain) return scanAt(row)->id;
    }
    return newestUncertain();
}

int KeyScanModel::uncertain() const {
    return static_cast<int>(
        std::count_if(m_scans->scans.begin(), m_scans->scans.end(),
                      [](const LiveKeyScan& scan) { return scan.pose.trust == ScanTrust::Uncertain; }));
}

int KeyScanModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_scans->scans.size());
}

int KeyScanModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString KeyScanModel::text(const LiveKeyScan& scan, int column) const {
    switch (column) {
        case Name: {
            const auto letter = m_letters.find(scan.scan->robot);
            return QStringLiteral("%1 %2")
                .arg(letter == m_letters.end() ? QStringLiteral("?") : letter->second)
                .arg(scan.id);
        }
        case Trust:
            return trustText(scan.pose.trust);
        case Doubts:
            return doubtText(scan.pose.doubts);
        case Overlap:
            return scan.matched == 0 ? QStringLiteral("–") : percentText(scan.pose.overlap);
        case Entered:
            return clockText(scan.entered);
        default:
            return {};
    }
}

QVariant KeyScanModel::data(const QModelIndex& index, int role) const {
    const LiveKeyScan* const scan = index.isValid() ? scanAt(index.row()) : nullptr;
    if (scan == nullptr) return {};
    switch (role) {
        case Qt::DisplayRole:
            return text(*scan, index.column());
        case Qt::ToolTipRole:
            return keyScanDetails(*scan);
        case Qt::TextAlignmentRole:
            return QVariant::fromValue(Qt::AlignVCenter |
                                       (index.column() == Overlap ? Qt::AlignRight : Qt::AlignLeft));
        case ToneRole: {
            const Tone tone = toneOf(scan->pose.trust);
            const bool reported = index.column() == Trust || index.column() == Doubts;
            // Doubts about a scan that was accepted since are history.
            if (index.column() == Doubts && tone == Tone::Normal) return static_cast<int>(Tone::Muted);
            return static_cast<int>(tone == Tone::Attention && !reported ? Tone::Normal : tone);
        }
        default:
            return {};
    }
}

QVariant KeyScanModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Name:
            return tr("Scan");
        case Trust:
            return tr("Counts");
        case Doubts:
            return tr("Doubts");
        case Overlap:
            return tr("Overlap");
        case Entered:
            return tr("Entered");
        default:
            return {};
    }
}

QString keyScanDetails(const LiveKeyScan& scan) {
    QStringList lines;
    // A guessed motion is listed whatever the trust: it speaks against no scan.
    constexpr auto Guessed = static_cast<std::uint8_t>(ScanDoubt::Guessed);
    const QString doubts = doubtDetails(static_cast<std::uint8_t>(scan.pose.doubts & ~Guessed));
    if (!doubts.isEmpty() && scan.pose.trust == ScanTrust::Uncertain) lines += doubts;
    if (scan.pose.trust == ScanTrust::SetAside) {
        lines += KeyScanModel::tr("Set aside by the operator: neither shown nor used.");
    } else if (doubts.isEmpty()) {
        lines += KeyScanModel::tr("It fits.");
    } else if (scan.pose.trust == ScanTrust::Certain) {
        lines += KeyScanModel::tr("Accepted by the operator.");
    }
    if (has(scan.pose.doubts, ScanDoubt::Guessed)) lines += doubtDetails(Guessed);
    if (scan.matched != 0) {
        lines += KeyScanModel::tr("Overlap %1, pairs %2 mm apart, certainty %3, matched near scan %4")
                     .arg(percentText(scan.pose.overlap), millimetresText(scan.pose.rms),
                          numberText(scan.pose.certainty, 2))
                     .arg(scan.matched);
    }
    return lines.join(QLatin1Char('\n'));
}

QString keyScanSummary(const KeyScanModel& model) {
    const QString scans = model.rowCount() == 1 ? KeyScanModel::tr("1 key scan")
                                                : KeyScanModel::tr("%1 key scans").arg(model.rowCount());
    if (model.uncertain() == 0) return scans;
    return scans + QStringLiteral(" · ") + KeyScanModel::tr("%1 for you to decide").arg(model.uncertain());
}

}  // namespace leitstand
