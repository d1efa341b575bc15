#include "app/services/review/playing/review_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {
namespace {

using Clock = std::chrono::steady_clock;
using Nanoseconds = std::chrono::nanoseconds;

constexpr std::chrono::milliseconds Tick(33), TickAround(200);  ///< the latter while it goes backwards
constexpr std::chrono::seconds LongestTick(1);                  ///< so that a busy computer makes no leaps

/// Returns @p at, or where the recording goes on from there in the direction of @p rate.
Time passedOver(const std::vector<TimelineStretch>& stretches, Time at, double rate) {
    const auto next = std::find_if(stretches.begin(), stretches.end(),
                                   [at](const TimelineStretch& one) { return one.to >= at; });
    if (next == stretches.end() || next->from <= at) return at;
    if (rate >= 0.0) return next->from;
    return next == stretches.begin() ? next->from : std::prev(next)->to;
}

}  // namespace

Result<std::unique_ptr<ReviewPlayer>> ReviewPlayer::open(const std::filesystem::path& mission,
                                                         ReviewListener listener) {
    auto log = ReviewLog::open(mission);
    if (!log) return log.error();
    return std::unique_ptr<ReviewPlayer>(new ReviewPlayer(std::move(log).value(), std::move(listener)));
}

ReviewPlayer::ReviewPlayer(std::unique_ptr<ReviewLog> log, ReviewListener listener)
    : m_log(std::move(log)),
      m_listener(std::move(listener)),
      m_first(m_log->first()),
      m_last(m_log->last()),
      m_mapsOffline(m_log->lacksMap()),
      m_position(m_first) {
    if (!robots().empty()) m_watched = robots().front().name;
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ReviewPlayer::~ReviewPlayer() = default;

void ReviewPlayer::wake() {
    m_changed = true;
    m_woken.notify_all();
}

void ReviewPlayer::play(double rate) {
    const std::lock_guard lock(m_mutex);
    const double size = std::abs(rate);
    const bool stands = !(size > 0.0);  // also NaN
    m_rate = stands ? 0.0 : std::copysign(std::clamp(size, Slowest, Fastest), rate);
    wake();
}

double ReviewPlayer::rate() const {
    const std::lock_guard lock(m_mutex);
    return m_rate;
}

void ReviewPlayer::seek(Time at) {
    const std::lock_guard lock(m_mutex);
    m_position = std::clamp(at, m_first, m_last);
    m_sought = true;
    wake();
}

void ReviewPlayer::step(Nanoseconds by) {
    const std::lock_guard lock(m_mutex);
    m_position = std::clamp(m_position + by, m_first, m_last);
    m_sought = true;
    wake();
}

void ReviewPlayer::watch(const std::string& robot) {
    const std::lock_guard lock(m_mutex);
    m_watched = robot;
    wake();
}

void ReviewPlayer::show(ReviewMap map) {
    const std::lock_guard lock(m_mutex);
    m_map = map;
    wake();
}

ReviewMap ReviewPlayer::map() const {
    const std::lock_guard lock(m_mutex);
    return m_map;
}

Time ReviewPlayer::position() const {
    const std::lock_guard lock(m_mutex);
    return m_position;
}

ReviewMomentPtr ReviewPlayer::moment() const {
    const std::lock_guard lock(m_mutex);
    return m_moment;
}

void ReviewPlayer::advance(Nanoseconds real, const ReviewIndex& index) {
    const auto by = Nanoseconds(static_cast<std::int64_t>(m_rate * static_cast<double>(real.count())));
    const Time wanted = passedOver(index.stretches, m_position + by, m_rate);
    m_position = std::clamp(wanted, m_first, m_last);
    if (m_position == (m_rate > 0.0 ? m_last : m_first)) m_rate = 0.0;
}

void ReviewPlayer::show(ReviewScene& scene, Time at, bool around) {
    ReviewMomentPtr made = scene.at(at, around);
    {
        const std::lock_guard lock(m_mutex);
        m_moment = made;
    }
    if (m_listener.onMoment) m_listener.onMoment(made);
}

ReviewIndexPtr ReviewPlayer::opened(const std::stop_token& stop) {
    double begin = 0.0, share = 1.0;
    const auto report = [&](double fraction) {
        if (m_listener.onOpening) m_listener.onOpening(begin + share * fraction);
    };
    if (m_mapsOffline) {
        const std::stop_callback both(stop, [this] { m_mapping.request_stop(); });
        share = MapPart;
        m_log->makeMap({report, m_mapping.get_token()});
        begin = MapPart;
        share = 1.0 - MapPart;
    }
    return indexOf(*m_log, {report, stop});
}

void ReviewPlayer::run(const std::stop_token& stop) {
    const ReviewIndexPtr index = opened(stop);
    if (stop.stop_requested()) return;
    {
        const std::lock_guard lock(m_mutex);
        if (!m_sought) m_position = std::clamp(index->opensAt, m_first, m_last);
    }
    if (m_listener.onIndex) m_listener.onIndex(index);
    ReviewScene scene(*m_log, *index);
    auto before = Clock::now(), around = before - TickAround;
    std::size_t reported = 0;
    while (!stop.stop_requested()) {
        Time at{};
        bool backwards = false, asked = false;
        {
            std::unique_lock lock(m_mutex);
            if (m_rate == 0.0) {
                m_woken.wait(lock, stop, [this] { return m_changed; });
                before = Clock::now();
            } else {
                m_woken.wait_until(lock, stop, before + Tick, [this] { return m_changed; });
            }
            if (stop.stop_requested()) return;
            asked = std::exchange(m_changed, false);
            const auto now = Clock::now();
            backwards = m_rate < 0.0;
            if (m_rate != 0.0) advance(std::min<Nanoseconds>(now - before, LongestTick), *index);
            before = now;
            at = m_position;
            asked = asked || m_rate == 0.0;  // where it stops, everything is shown
            scene.watch(m_watched);
            scene.show(m_map);
        }
        const bool look = asked || !backwards || Clock::now() - around >= TickAround;
        if (look) around = Clock::now();
        show(scene, at, look);
        const auto problems = m_log->problems();
        for (; reported < problems.size(); ++reported) {
            if (m_listener.onMessage) m_listener.onMessage(problems[reported]);
        }
    }
}

}  // namespace leitstand
