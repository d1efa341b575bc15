#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/page_store.h"
#include "core/cloud/packed_cloud.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// The cloud of a key scan for matching. Any thread.
class MatchedCloud {
public:
    /// Makes a cloud that stays in memory.
    explicit MatchedCloud(const PointCloud& cloud);
    ~MatchedCloud();
    MatchedCloud(const MatchedCloud&) = delete;
    MatchedCloud& operator=(const MatchedCloud&) = delete;

    /// Returns the number of points, without waiting for the disk. Empty: the cloud was not made yet, because
    /// it was never used.
    [[nodiscard]] std::optional<std::size_t> size() const;
    /// Returns the cloud. It is bit for bit the same wherever it was stored; it is read again if it is not in
    /// memory.
    [[nodiscard]] PointCloud unpacked() const;
    /// Returns how much memory it uses now [B].
    [[nodiscard]] std::size_t memory() const;

private:
    friend class MatchedClouds;
    struct Shelf;
    struct Place;
    /// @p cloud may be null. Then @p again makes the cloud when it is first used.
    MatchedCloud(const PointCloud* cloud, std::shared_ptr<Shelf> shelf, std::function<PointCloud()> again);

    std::unique_ptr<Place> m_place;
    std::shared_ptr<Shelf> m_shelf;  ///< null: the cloud stays in memory
};
using MatchedCloudPtr = std::shared_ptr<const MatchedCloud>;

/// Keeps the clouds of a map's key scans for matching. Recently used clouds, which are around the robots, are
/// in memory, the others in a store. A map of one hour has more than a thousand key scans; a scan is matched
/// against a dozen.
class MatchedClouds {
public:
    /// Enough for two robots: a dozen clouds for each robot's local map, and a dozen for the next one that it
    /// reaches.
    static constexpr std::size_t Usual = 48;

    /// @p store may be null: all clouds stay in memory. @p inMemory: number of clouds in memory if there is a
    /// store.
    explicit MatchedClouds(std::shared_ptr<PageStore> store = nullptr, std::size_t inMemory = Usual);
    ~MatchedClouds();
    MatchedClouds(MatchedClouds&&) noexcept;
    MatchedClouds& operator=(MatchedClouds&&) noexcept;

    /// Keeps @p cloud. @p again makes the cloud once more if the store cannot return it.
    [[nodiscard]] MatchedCloudPtr keep(const PointCloud& cloud, std::function<PointCloud()> again) const;
    /// Returns a cloud that @p make makes when it is first used: most scans of an earlier map are never
    /// matched.
    [[nodiscard]] MatchedCloudPtr promise(std::function<PointCloud()> make) const;

private:
    std::shared_ptr<MatchedCloud::Shelf> m_shelf;
};

}  // namespace leitstand
