#include "app/window/live/live_bridge.h"

#include <chrono>
#include <utility>

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Tick(33);

}  // namespace

LiveBridge::LiveBridge() {
    m_tick.setInterval(Tick);
    connect(&m_tick, &QTimer::timeout, this, &LiveBridge::ticked);
}

LiveBridge::~LiveBridge() = default;

Result<std::unique_ptr<LiveBridge>> LiveBridge::open(const StationSettings& settings) {
    std::unique_ptr<LiveBridge> bridge(new LiveBridge);
    LiveBridge* const raw = bridge.get();
    const auto tell = [raw](const std::string& text) {
        raw->hop([raw, text = QString::fromStdString(text)] { emit raw->told(text); });
    };
    bridge->m_pictures = std::make_unique<PictureFeed>(
        settings.mission.robots,
        PictureFeed::Listener{
            [raw](const ShownPicturePtr& one) { raw->hop([raw, one] { emit raw->pictured(one); }); }, tell});
    StationListener listener;
    listener.onMessage = tell;
    listener.onEvent = [raw](const Event& event) { raw->m_pictures->take(event); };
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
