#include "core/io/bag/writing/disk_watch.h"

#include <utility>

#include "core/station/alarms/log_format.h"

namespace leitstand::detail {

namespace {

using std::chrono::duration;
using std::chrono::seconds;

constexpr auto Window = seconds(10);  // the rate is the mean over it
constexpr double Least = 1.0;         // [s], since commits come in bursts
constexpr auto Calm = seconds(5);     // an alarm ends after this time without drops
constexpr double Behind = 2.0;        // [s]

std::string lastsAgain(const std::string& file, double minutes) {
    return minutes < 6'000.0 ? log_format::about(file, log_format::DiskLasts, loggedFigure(minutes))
                             : log_format::about(file, log_format::DiskLastsForDays);
}

}  // namespace

void DiskWatch::measure(const DiskReading& reading) {
    m_marks.push_back({reading.now, reading.writtenBytes});
    while (m_marks.size() > 2 && reading.now - m_marks.front().time > Window) m_marks.pop_front();
    const double elapsed = duration<double>(m_marks.back().time - m_marks.front().time).count();
    if (elapsed >= Least) {
        m_rate = static_cast<double>(m_marks.back().bytes - m_marks.front().bytes) / elapsed;
    }
    const double left = static_cast<double>(reading.freeBytes) / m_rate / 60.0;
    m_minutesLeft = reading.full ? 0.0 : m_rate > 0.0 ? left : std::numeric_limits<double>::infinity();
}

void DiskWatch::judge(BagAlarm::Kind kind, bool raised, const std::string& text, const std::string& over,
                      std::vector<BagAlarm>& changed) {
    bool& before = m_raised[kind];
    if (before == raised) return;
    before = raised;
    changed.push_back({kind, raised, m_minutesLeft, raised ? text : over});
}

std::vector<BagAlarm> DiskWatch::update(const DiskReading& reading) {
    measure(reading);
    if (reading.droppedPictures > m_droppedPictures) m_lastDrop = reading.now;
    if (reading.lostEvents > m_lostEvents) m_lastLoss = reading.now;
    m_droppedPictures = reading.droppedPictures;
    m_lostEvents = reading.lostEvents;
    const bool dropping = m_droppedPictures > 0 && reading.now - m_lastDrop < Calm;
    const bool losing = m_lostEvents > 0 && reading.now - m_lastLoss < Calm;
    const std::string megabytes = loggedFigure(static_cast<double>(reading.queuedBytes) * 1e-6);

    std::vector<BagAlarm> changed;
    using Kind = BagAlarm::Kind;
    // An alarm that is nearly over must not end and begin again with every reading.
    const double margin = m_raised[Kind::DiskFilling] ? 1.2 : 1.0;
    const auto textOf = [&](const LogPhrase& phrase, const auto&... values) {
        return log_format::about(reading.where, phrase, values...);
    };
    judge(Kind::DiskFilling, m_minutesLeft < m_alarmMinutes * margin,
          textOf(log_format::DiskFilling, loggedFigure(m_minutesLeft), loggedFigure(m_rate * 1e-6, 1)),
          lastsAgain(reading.where, m_minutesLeft), changed);
    judge(Kind::DiskFull, reading.full, textOf(log_format::DiskFull, megabytes), textOf(log_format::DiskFree),
          changed);
    judge(Kind::DiskSlow, !reading.full && (dropping || reading.secondsBehind > Behind),
          textOf(log_format::DiskSlow, loggedFigure(reading.secondsBehind, 1), megabytes,
                 reading.droppedPictures),
          textOf(log_format::DiskKeepsUp, reading.droppedPictures), changed);
    judge(Kind::EventsLost, losing, textOf(log_format::EventsLost, reading.lostEvents),
          textOf(log_format::EventsKept, reading.lostEvents), changed);
    judge(Kind::Failed, !reading.failure.empty(), reading.failure, textOf(log_format::WrittenAgain), changed);
    return changed;
}

}  // namespace leitstand::detail
