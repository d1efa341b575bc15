#include "app/window/source/review_bridge.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <utility>

#include <QSysInfo>

#include "app/services/recorded/review_cadence.h"
#include "app/services/review/playing/newest_writing.h"
#include "app/services/review/reviewed_robot.h"
#include "app/window/source/review_comparison.h"
#include "app/window/source/review_report.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "core/version/version.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Tick(33);
/// Multiples of the usual time between two samples in the mission.
constexpr double StaleAfter = 2.5, LostAfter = 5.0;

/// Returns the limits of a stream of @p rate [Hz]: as for live ones, or longer when it was recorded more
/// rarely.
FreshnessLimits limitsAt(double rate) {
    FreshnessLimits limits;
    if (rate <= 0.0) return limits;
    limits.stale = std::max(limits.stale, StaleAfter / rate);
    limits.lost = std::max(limits.lost, LostAfter / rate);
    return limits;
}

/// Returns what of @p values, by rising time, belongs to the trend at @p now.
ValueTrend trendBefore(Time now, const std::vector<std::pair<Time, double>>& values) {
    constexpr auto Span =
        std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(ValueTrend::Span));
    ValueTrend trend;
    auto one = std::lower_bound(values.begin(), values.end(), now - Span,
                                [](const auto& value, Time at) { return value.first < at; });
    for (; one != values.end() && one->first <= now; ++one) trend.add(one->first, one->second);
    return trend;
}

}  // namespace

ReviewBridge::ReviewBridge() : m_writer([this](const std::stop_token& stop) { m_writing.work(stop); }) {
    m_tick.setInterval(Tick);
    connect(&m_tick, &QTimer::timeout, this, &ReviewBridge::tick);
}

ReviewBridge::~ReviewBridge() {
    std::promise<void> written;  // closing the window at once loses nothing that was written
    m_writing.submit([&written](const std::stop_token&) { written.set_value(); }, false);
    written.get_future().wait();
}

Result<std::unique_ptr<ReviewBridge>> ReviewBridge::open(const std::filesystem::path& mission) {
    std::unique_ptr<ReviewBridge> bridge(new ReviewBridge);
    ReviewBridge* const raw = bridge.get();
    const auto notifyWindow = [raw](const std::string& text) {
        raw->hop([raw, text = QString::fromStdString(text)] { raw->notify(text); });
    };
    ReviewListener listener;
    listener.onOpening = [raw, reported = 0.0](double fraction) mutable {
        if (fraction < reported + 0.01) return;  // not a call for every event
        reported = fraction;
        raw->hop([raw, fraction] {
            if (!raw->m_index) emit raw->opening(fraction);
        });
    };
    listener.onIndex = [raw](const ReviewIndexPtr& index) {
        raw->hop([raw, index] {
            raw->m_index = index;
            raw->m_comparison->recall(index);
            raw->m_pen->know(index->finished);
            emit raw->opened(index);
        });
    };
    listener.onMessage = notifyWindow;
    auto player = ReviewPlayer::open(mission, std::move(listener));
    if (!player) return player.error();
    bridge->m_player = std::move(player).value();
    bridge->m_comparison = std::make_unique<ReviewComparison>(bridge->m_player->folder());
    bridge->m_report = std::make_unique<ReviewReport>(bridge->m_player->folder());
    connect(bridge->m_comparison.get(), &ReviewComparison::finished, raw, &ReviewBridge::notify);
    connect(bridge->m_report.get(), &ReviewReport::notified, raw, &ReviewBridge::notify);
    bridge->m_pen = std::make_unique<ReviewPen>(
        bridge->m_player->folder(), bridge->robots(),
        std::string(ReviewStation) + "-" + QSysInfo::machineHostName().toStdString(), version());
    bridge->m_pictures = std::make_unique<PictureFeed>(
        bridge->robots(), PictureFeed::Listener{[raw](const ShownPicturePtr& one) {
                                                    raw->hop([raw, one] {
                                                        raw->m_again = true;
                                                        emit raw->pictured(one);
                                                    });
                                                },
                                                notifyWindow});
    if (!bridge->robots().empty()) bridge->m_watched = bridge->robots().front().name;
    bridge->m_tick.start();
    return bridge;
}

void ReviewBridge::write(std::function<Result<void>(ReviewPen&)> what, const QString& done) {
    m_writing.submit(
        [this, what = std::move(what), done](const std::stop_token&) {
            const Result<void> result = what(*m_pen);
            hop([this, done, problem = result ? QString() : QString::fromStdString(result.error().text)] {
                emit wrote(done, problem);
            });
        },
        false);
}

void ReviewBridge::reportInto(const QString& folder) {
    ++m_reportsAsked;
    m_writing.submit(
        [this, folder](const std::stop_token&) {
            const Result<void> there = m_pen->flush();
            hop([this, folder, problem = there ? QString() : QString::fromStdString(there.error().text)] {
                if (!problem.isEmpty()) notify(problem);
                --m_reportsAsked;
                m_report->begin(folder);
            });
        },
        false);
}

bool ReviewBridge::reporting() const {
    return m_reportsAsked > 0 || m_report->writing();
}

void ReviewBridge::showInstead(MapPtr map) {
    if (map == m_instead) return;
    m_instead = std::move(map);
    if (m_shown) emit mapChanged(m_instead ? m_instead : m_shown->map);
}

void ReviewBridge::showAgain() {
    m_shown.reset();
    m_fed.clear();
    if (m_instead) emit mapChanged(m_instead);
    if (m_index) emit opened(m_index);
    tick();
}

void ReviewBridge::watch(const std::string& robot) {
    m_watched = robot;
    m_player->watch(robot);
}

SteadyTime ReviewBridge::arrivalOf(const ShownPicture& picture) const {
    return steadyOf(picture.received);
}

FreshnessLimits ReviewBridge::pictureLimits(const std::string& robot, const std::string& sensor) const {
    if (!m_index) return {};
    for (const RobotDescription& one : robots()) {
        if (one.name != robot) continue;
        for (const StreamRole role : {StreamRole::Picture, StreamRole::Thermal}) {
            if (const StreamDescription* const stream = one.stream(role, sensor))
                return limitsAt(usualRate(*m_index, robot, stream->topic));
        }
    }
    return {};
}

MomentSource::ScanSource ReviewBridge::scanSource(const std::string& robot) const {
    if (!m_index) return {};
    if (!hasSlices(*m_index, robot)) return {true, limitsAt(keyScanRate(*m_index, robot))};
    double rate = 0.0;
    for (const RobotDescription& one : robots()) {
        for (const StreamDescription& stream : one.streams) {
            if (one.name == robot && isScanner(stream.role))
                rate = std::max(rate, usualRate(*m_index, robot, stream.topic));
        }
    }
    return {false, limitsAt(rate)};
}

ValueTrend ReviewBridge::gas(const std::string& robot) const {
    if (!m_index) return {};
    const auto found = m_index->gas.find(robot);
    return found == m_index->gas.end() ? ValueTrend() : trendBefore(m_moment.now, found->second);
}

ValueTrend ReviewBridge::reading(const std::string& robot, const std::string& topic,
                                 std::size_t index) const {
    if (!m_index) return {};
    const auto found = m_index->readings.find({robot, topic});
    if (found == m_index->readings.end() || index >= found->second.size()) return {};
    return trendBefore(m_moment.now, found->second[index]);
}

void ReviewBridge::showPictures(const ReviewMoment& moment) {
    for (const Event& event : moment.pictures) {
        const auto [fed, fresh] = m_fed.try_emplace(event.topic, event.sequence);
        if (!fresh && std::exchange(fed->second, event.sequence) == event.sequence) continue;
        m_pictures->onEvent(event);
    }
    for (const RobotDescription& robot : robots()) {
        if (robot.name != m_watched) continue;
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role != StreamRole::Picture && stream.role != StreamRole::Thermal) continue;
            const bool there = std::any_of(moment.pictures.begin(), moment.pictures.end(),
                                           [&](const Event& one) { return one.topic == stream.topic; });
            if (!there && m_fed.erase(stream.topic) > 0) emit pictureGone(robot.name, stream.sensor);
        }
    }
}

void ReviewBridge::tick() {
    const ReviewMomentPtr moment = m_player->moment();
    const bool again = std::exchange(m_again, false);
    if (!m_index || !moment || (moment == m_shown && !again)) return;
    const ReviewMomentPtr before = std::exchange(m_shown, moment);
    m_moment.now = moment->now;
    m_moment.steady = steadyOf(moment->now);
    m_moment.mission = moment->mission;
    m_moment.robots = moment->robots;
    m_moment.places = moment->places;
    m_moment.scans = moment->scans;
    showPictures(*moment);
    if (!m_instead && (!before || before->map != moment->map)) emit mapChanged(moment->map);
    if (!before || before->scans != moment->scans) emit scansChanged(moment->scans);
    emit ticked(m_moment);
}

}  // namespace leitstand
