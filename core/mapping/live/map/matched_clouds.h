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

    /// Returns the number of points, without waiting for the disk. Empty: it was not used yet, and so not
    /// made.
    [[nodiscard]] std::optional<std::size_t> size() const;
    /// Returns the cloud, bit for bit the same wherever it was stored; read again if it is not in memory.
    [[nodiscard]] PointCloud unpacked() const;
    /// Returns the bytes of memory that it takes now.
    [[nodiscard]] std::size_t memory() const;

private:
    friend class MatchedClouds;
    struct Shelf;
    struct Place;
    /// @p cloud may be null: then @p again makes the cloud on first use.
    MatchedCloud(const PointCloud* cloud, std::shared_ptr<Shelf> shelf, std::function<PointCloud()> again);

    std::unique_ptr<Place> m_place;
    std::shared_ptr<Shelf> m_shelf;  ///< null: stays in memory
};
using MatchedCloudPtr = std::shared_ptr<const MatchedCloud>;

/// Keeps the clouds of a map's key scans for matching. Clouds used lately, which are around the robots, are
/// in memory, the others in a store. An hour's map has more than a thousand key scans; a scan is matched
/// against a dozen.
class MatchedClouds {
public:
    /// Enough for two robots: the local map of each and the next one that it reaches, a dozen clouds each.
    static constexpr std::size_t Usual = 48;

    /// @p store may be null: then all clouds stay in memory. @p inMemory: number of clouds in memory if there
    /// is a store.
    explicit MatchedClouds(std::shared_ptr<PageStore> store = nullptr, std::size_t inMemory = Usual);
    ~MatchedClouds();
    MatchedClouds(MatchedClouds&&) noexcept;
    MatchedClouds& operator=(MatchedClouds&&) noexcept;

    /// Keeps @p cloud. @p again makes it again if the store cannot return it.
    [[nodiscard]] MatchedCloudPtr keep(const PointCloud& cloud, std::function<PointCloud()> again) const;
    /// Returns a cloud that @p make makes on first use: most scans of an earlier map are never matched.
    [[nodiscard]] MatchedCloudPtr promise(std::function<PointCloud()> make) const;

private:
    std::shared_ptr<MatchedCloud::Shelf> m_shelf;
};

}  // namespace leitstand
