#include "app/window/review/by_hand/by_hand_bridge.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include <QCoreApplication>
#include <QMetaObject>
#include <QSysInfo>

#include "app/services/mapping/live_mapping.h"
#include "app/services/places/mission_map.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds Tick(33);

}  // namespace

ByHandBridge::ByHandBridge()
    : m_tick(this),
      m_pictures(
          std::make_unique<PictureFeed>(std::vector<RobotDescription>(), PictureFeed::Listener{{}, {}})) {
    m_tick.setInterval(Tick);
    connect(&m_tick, &QTimer::timeout, this, &ByHandBridge::tick);
}

ByHandBridge::~ByHandBridge() = default;

SteadyTime ByHandBridge::arrivalOf(const ShownPicture& /*picture*/) const {
    return std::chrono::steady_clock::now();
}

Result<std::unique_ptr<ByHandBridge>> ByHandBridge::open(const std::filesystem::path& mission) {
    std::unique_ptr<ByHandBridge> bridge(new ByHandBridge);
    ByHandBridge* const raw = bridge.get();
    const auto hop = [raw](auto call) {
        QMetaObject::invokeMethod(raw, std::move(call), Qt::QueuedConnection);
    };
    StationMappingListener listener;
    listener.onMessage = [raw, hop](const std::string& text) {
        hop([raw, text = QString::fromStdString(text)] { raw->notify(text); });
    };
    listener.onMap = [raw, hop](const MapPtr& map) { hop([raw, map] { emit raw->mapChanged(map); }); };
    listener.onScans = [raw, hop](const LiveMapPtr& map) {
        hop([raw, map] { emit raw->scansChanged(map); });
    };
    auto hand = MapByHand::open(
        mission, std::string(MapByHandStation) + "-" + QSysInfo::machineHostName().toStdString(),
        QCoreApplication::applicationVersion().toStdString(), std::move(listener));
    if (!hand) return hand.error();
    bridge->m_hand = std::move(hand).value();
    return bridge;
}

void ByHandBridge::begin() {
    const LiveMapPtr scans = m_hand->mapping().scans();
    emit mapChanged(shownMap(*scans));
    emit scansChanged(scans);
    tick();
    m_tick.start();
}

void ByHandBridge::tick() {
    m_moment.scans = m_hand->mapping().scans();
    // Nothing happens any more: ages are those at the mission's end.
    for (const LiveKeyScan& scan : m_moment.scans->scans) m_moment.now = std::max(m_moment.now, scan.entered);
    m_moment.steady = std::chrono::steady_clock::now();
    m_moment.mission = m_hand->state();
    m_moment.places = m_hand->mapping().robots();
    emit ticked(m_moment);
}

}  // namespace leitstand
