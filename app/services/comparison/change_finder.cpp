#include "app/services/comparison/change_finder.h"

#include <chrono>
#include <utility>

namespace leitstand {

std::vector<ReportScan> countingScans(const Map& map) {
    std::vector<ReportScan> scans;
    for (const MapScan& scan : map.scans) {
        if (!scan.uncertain && scan.id != 0)
            scans.push_back({.id = scan.id, .scan = scan.scan, .scanInMap = scan.poseInMap});
    }
    return scans;
}

ChangeFinder::ChangeFinder() {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

ChangeFinder::~ChangeFinder() = default;

void ChangeFinder::want(MapPtr map) {
    {
        const std::lock_guard lock(m_mutex);
        if (map == m_asked) return;
        m_asked = map;
        m_wanted = std::move(map);
        if (!m_asked) m_changes = nullptr;
    }
    m_came.notify_all();
}

MapChangesPtr ChangeFinder::changes() const {
    const std::lock_guard lock(m_mutex);
    return m_changes;
}

void ChangeFinder::run(const std::stop_token& stop) {
    constexpr int Rest = 4;  // times as long as it took
    while (true) {
        MapPtr map;
        {
            std::unique_lock lock(m_mutex);
            if (!m_came.wait(lock, stop, [this] { return m_wanted.has_value(); })) return;
            map = std::move(*std::exchange(m_wanted, std::nullopt));
        }
        if (!map) continue;
        const auto begin = std::chrono::steady_clock::now();
        auto found = std::make_shared<const MapChanges>(
            changesOf(countingScans(*map), {}, {.report = {}, .stop = stop}));
        if (stop.stop_requested()) return;
        std::unique_lock lock(m_mutex);
        if (m_asked) m_changes = std::move(found);
        m_came.wait_for(lock, stop, Rest * (std::chrono::steady_clock::now() - begin), [] { return false; });
    }
}

}  // namespace leitstand
