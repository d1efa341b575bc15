#pragma once

#include <cstddef>
#include <functional>
#include <memory>

#include "core/base/page_store.h"
#include "core/cloud/packed_cloud.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// What is matched of a key scan. Any thread; how many points it has is known without waiting for the disk.
class MatchedCloud {
public:
    /// Stays in memory.
    explicit MatchedCloud(const PointCloud& cloud);
    ~MatchedCloud();
    MatchedCloud(const MatchedCloud&) = delete;
    MatchedCloud& operator=(const MatchedCloud&) = delete;

    [[nodiscard]] std::size_t size() const { return m_size; }
    /// The cloud, bit for bit the same wherever it waited; read again where it is out of memory.
    [[nodiscard]] PointCloud unpacked() const;
    /// Bytes of memory that it takes now.
    [[nodiscard]] std::size_t memory() const;

private:
    friend class MatchedClouds;
    struct Shelf;
    struct Place;
    MatchedCloud(const PointCloud& cloud, std::shared_ptr<Shelf> shelf, std::function<PointCloud()> again);

    std::size_t m_size;
    std::unique_ptr<Place> m_place;
    std::shared_ptr<Shelf> m_shelf;  ///< null: stays in memory
};
using MatchedCloudPtr = std::shared_ptr<const MatchedCloud>;

/// Keeps what is matched of a map's key scans: in memory where it was used lately, which is about the robots,
/// else in a store. An hour's map has more than a thousand key scans, a scan is matched against a dozen.
class MatchedClouds {
public:
    /// A robot's local map, twice, and what it comes to next: a dozen each, and as much for another robot.
    static constexpr std::size_t Usual = 48;

    /// @p store: null: all stay in memory. @p inMemory: clouds, the others are in the store.
    explicit MatchedClouds(std::shared_ptr<PageStore> store = nullptr, std::size_t inMemory = Usual);
    ~MatchedClouds();
    MatchedClouds(MatchedClouds&&) noexcept;
    MatchedClouds& operator=(MatchedClouds&&) noexcept;

    /// @p again makes one like it where the store does not give it back.
    [[nodiscard]] MatchedCloudPtr keep(const PointCloud& cloud, std::function<PointCloud()> again) const;

private:
    std::shared_ptr<MatchedCloud::Shelf> m_shelf;
};

}  // namespace leitstand
