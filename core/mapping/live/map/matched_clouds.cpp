#include "core/mapping/live/map/matched_clouds.h"

#include <algorithm>
#include <cstdint>
#include <list>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace leitstand {

using PackedPtr = std::shared_ptr<const PackedCloud>;

/// Where a cloud is: in memory, in the store, or both. Guarded by the shelf's mutex.
struct MatchedCloud::Place {
    std::optional<std::size_t> size;    ///< number of points; empty: it was never made
    PackedPtr packed;                   ///< null: only in the store, if it was made
    std::optional<std::uint64_t> page;  ///< in the store; its content stays the same
    std::size_t pageBytes = 0;
    std::list<Place*>::iterator used;  ///< only while packed
    std::function<PointCloud()> again;
};

/// The clouds that are in memory, newest use first.
struct MatchedCloud::Shelf {
    std::shared_ptr<PageStore> store;
    std::size_t most = 0;
    std::mutex mutex;
    std::list<Place*> used;

    void take(Place& place, PackedPtr packed);
    [[nodiscard]] PackedPtr use(Place& place);
    void forget(Place& place);

private:
    void makeRoom();
    [[nodiscard]] std::optional<PackedCloud> read(const Place& place) const;
};

/// Puts @p packed in as the most recently used. The mutex is held.
void MatchedCloud::Shelf::take(Place& place, PackedPtr packed) {
    place.packed = std::move(packed);
    used.push_front(&place);
    place.used = used.begin();
    makeRoom();
}

PackedPtr MatchedCloud::Shelf::use(Place& place) {
    std::unique_lock lock(mutex);
    if (!place.packed) {
        if (auto packed = read(place)) {
            take(place, std::make_shared<const PackedCloud>(*std::move(packed)));
        } else {
            lock.unlock();  // others of the shelf may be needed for it
            const PointCloud cloud = place.again();
            auto made = std::make_shared<const PackedCloud>(cloud);
            lock.lock();
            place.size = cloud.size();
            if (!place.packed) take(place, std::move(made));
        }
    } else {
        used.splice(used.begin(), used, place.used);
    }
    return place.packed;
}

void MatchedCloud::Shelf::forget(Place& place) {
    const std::lock_guard lock(mutex);
    if (place.packed) used.erase(place.used);
    if (place.page) store->release(*place.page, place.pageBytes);
}

/// Releases the least recently used clouds; a cloud stays if the store has no space for it.
void MatchedCloud::Shelf::makeRoom() {
    while (store && used.size() > most) {
        Place& oldest = *used.back();
        if (!oldest.page) {
            const std::vector<std::byte> bytes = oldest.packed->bytes();
            oldest.page = store->put(bytes);
            oldest.pageBytes = bytes.size();
            if (!oldest.page) return;
        }
        oldest.packed.reset();
        used.pop_back();
    }
}

std::optional<PackedCloud> MatchedCloud::Shelf::read(const Place& place) const {
    std::vector<std::byte> bytes(place.pageBytes);
    if (!place.page || !store->read(*place.page, bytes)) return std::nullopt;
    return PackedCloud::fromBytes(bytes);
}

MatchedCloud::MatchedCloud(const PointCloud& cloud) : m_place(std::make_unique<Place>()) {
    m_place->size = cloud.size();
    m_place->packed = std::make_shared<const PackedCloud>(cloud);
}

MatchedCloud::MatchedCloud(const PointCloud* cloud, std::shared_ptr<Shelf> shelf,
                           std::function<PointCloud()> again)
    : m_place(std::make_unique<Place>()), m_shelf(std::move(shelf)) {
    m_place->again = std::move(again);
    if (cloud == nullptr) return;
    m_place->size = cloud->size();
    const std::lock_guard lock(m_shelf->mutex);
    m_shelf->take(*m_place, std::make_shared<const PackedCloud>(*cloud));
}

MatchedCloud::~MatchedCloud() {
    if (m_shelf) m_shelf->forget(*m_place);
}

std::optional<std::size_t> MatchedCloud::size() const {
    if (!m_shelf) return m_place->size;
    const std::lock_guard lock(m_shelf->mutex);
    return m_place->size;
}

PointCloud MatchedCloud::unpacked() const {
    return (m_shelf ? m_shelf->use(*m_place) : m_place->packed)->unpacked();
}

std::size_t MatchedCloud::memory() const {
    if (!m_shelf) return m_place->packed->memory();
    const std::lock_guard lock(m_shelf->mutex);
    return m_place->packed ? m_place->packed->memory() : 0;
}

MatchedClouds::MatchedClouds(std::shared_ptr<PageStore> store, std::size_t inMemory)
    : m_shelf(std::make_shared<MatchedCloud::Shelf>()) {
    m_shelf->store = std::move(store);
    m_shelf->most = std::max<std::size_t>(1, inMemory);  // one is in use
}

MatchedClouds::~MatchedClouds() = default;
MatchedClouds::MatchedClouds(MatchedClouds&&) noexcept = default;
MatchedClouds& MatchedClouds::operator=(MatchedClouds&&) noexcept = default;

MatchedCloudPtr MatchedClouds::keep(const PointCloud& cloud, std::function<PointCloud()> again) const {
    return MatchedCloudPtr(new MatchedCloud(&cloud, m_shelf, std::move(again)));
}

MatchedCloudPtr MatchedClouds::promise(std::function<PointCloud()> make) const {
    return MatchedCloudPtr(new MatchedCloud(nullptr, m_shelf, std::move(make)));
}

}  // namespace leitstand
