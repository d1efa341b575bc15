#include "app/window/source/live_bridge.h"

#include <chrono>
#include <utility>

#include "app/services/log/sequencer.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/station/station_mapping.h"
#include "core/event/status_samples.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Tick(33);
/// Ticks between updates of what is around: without new scans, and with them. Slices come ten times a second.
/// They are not in step with ticks: with 3 ticks some would wait for the picture of the next one.
constexpr int TicksAround = 3, TicksScanned = 2;

}  // namespace

LiveBridge::LiveBridge() {
    m_tick.setInterval(Tick);
    connect(&m_tick, &QTimer::timeout, this, &LiveBridge::tick);
}

LiveBridge::~LiveBridge() = default;

const std::vector<RobotDescription>& LiveBridge::robots() const {
    return m_station->robots();
}

SteadyTime LiveBridge::arrivalOf(const ShownPicture& /*picture*/) const {
    return std::chrono::steady_clock::now();
}

void LiveBridge::watch(const std::string& robot) {
    if (robot == m_watched) return;
    m_watched = robot;
    m_around.reset();
    m_sinceAround = TicksAround;
    tick();
}

void LiveBridge::showAgain() {
    const LiveMapPtr scans = m_station->mapping().scans();
    if (scans->scans.empty()) return;
    emit mapChanged(shownMap(*scans));
    emit scansChanged(scans);
}

void LiveBridge::keepTrends() {
    for (const RobotDescription& robot : m_station->robots()) {
        const RobotState& reported = m_moment.reported(robot.name);
        if (reported.gas) m_gas[robot.name].add(reported.gas->received, reported.gas->sample.ppm);
        for (const auto& [topic, latest] : reported.readings) {
            const std::vector<double>& values = latest->sample.values;
            std::vector<ValueTrend>& trends = m_readings[{robot.name, topic}];
            trends.resize(values.size());
            for (std::size_t i = 0; i < values.size(); ++i) trends[i].add(latest->received, values[i]);
        }
    }
}

ValueTrend LiveBridge::gas(const std::string& robot) const {
    const auto found = m_gas.find(robot);
    return found == m_gas.end() ? ValueTrend() : found->second;
}

ValueTrend LiveBridge::reading(const std::string& robot, const std::string& topic, std::size_t index) const {
    const auto found = m_readings.find({robot, topic});
    return found == m_readings.end() || index >= found->second.size() ? ValueTrend() : found->second[index];
}

void LiveBridge::lookAround() {
    const auto scanned = m_station->scanned(m_watched);
    if (++m_sinceAround < (scanned == m_scanned ? TicksAround : TicksScanned)) return;
    m_sinceAround = 0;
    m_scanned = scanned;
    m_around = m_station->surroundings(m_watched);
}

void LiveBridge::tick() {
    m_moment.now = stationTime();
    m_moment.steady = std::chrono::steady_clock::now();
    m_moment.mission = m_station->mission();
    m_moment.places = m_station->mapping().robots();
    m_moment.scans = m_station->mapping().scans();
    m_moment.robots.clear();
    for (const RobotDescription& robot : m_station->robots())
        m_moment.robots[robot.name] = m_station->robot(robot.name);
    keepTrends();
    lookAround();
    if (const auto watched = m_moment.robots.find(m_watched); watched != m_moment.robots.end())
        watched->second.around = m_around;
    emit ticked(m_moment);
}

Result<std::unique_ptr<LiveBridge>> LiveBridge::open(const StationSettings& settings) {
    std::unique_ptr<LiveBridge> bridge(new LiveBridge);
    LiveBridge* const raw = bridge.get();
    const auto notifyWindow = [raw](const std::string& text) {
        raw->hop([raw, text = QString::fromStdString(text)] { raw->notify(text); });
    };
    bridge->m_pictures = std::make_unique<PictureFeed>(
        settings.mission.robots, PictureFeed::Listener{[raw](const ShownPicturePtr& one) {
                                                           raw->hop([raw, one] { emit raw->pictured(one); });
                                                       },
                                                       notifyWindow});
    StationListener listener;
    listener.onMessage = notifyWindow;
    listener.onEvent = [raw](const Event& event) { raw->m_pictures->onEvent(event); };
    listener.onMap = [raw](const MapPtr& map) { raw->hop([raw, map] { emit raw->mapChanged(map); }); };
    listener.onScans = [raw](const LiveMapPtr& map) {
        raw->hop([raw, map] { emit raw->scansChanged(map); });
    };
    auto station = Station::open(settings, std::move(listener));
    if (!station) return station.error();
    bridge->m_station = std::move(station).value();
    bridge->m_tick.start();
    return bridge;
}

}  // namespace leitstand
