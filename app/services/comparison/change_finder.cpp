#include "app/services/comparison/change_finder.h"

#include <chrono>
#include <new>
#include <stop_token>
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
        // Changes of a growing map stay valid meanwhile; those of another map are wrong.
        if (!map || !m_asked || map->scans.size() < m_asked->scans.size()) {
            m_changes = nullptr;
            m_atWork.request_stop();
            m_another = true;
        }
        m_asked = map;
        m_wanted = std::move(map);
    }
    m_came.notify_all();
}

MapChangesPtr ChangeFinder::changes() const {
    const std::lock_guard lock(m_mutex);
    return m_changes;
}

void ChangeFinder::run(const std::stop_token& stop) {
    constexpr int Rest = 4;  // in multiples of the time that the search took
    while (true) {
        MapPtr map;
        std::stop_token another;
        {
            std::unique_lock lock(m_mutex);
            if (!m_came.wait(lock, stop, [this] { return m_wanted.has_value(); })) return;
            map = std::move(*std::exchange(m_wanted, std::nullopt));
            m_another = false;
            m_atWork = std::stop_source();
            another = m_atWork.get_token();
        }
        if (!map) continue;
        const std::stop_callback ends(stop, [this] {
            const std::lock_guard lock(m_mutex);
            m_atWork.request_stop();
        });
        const auto begin = std::chrono::steady_clock::now();
        MapChangesPtr found;
        try {
            found = std::make_shared<const MapChanges>(
                changesOf(countingScans(*map), {}, {.report = {}, .stop = another}));
        } catch (const std::bad_alloc&) {
            // Changes are not reported; there may be memory again for a later map.
        }
        std::unique_lock lock(m_mutex);
        if (another.stop_requested()) continue;
        m_changes = std::move(found);
        m_came.wait_for(lock, stop, Rest * (std::chrono::steady_clock::now() - begin),
                        [this] { return m_another; });
    }
}

}  // namespace leitstand
