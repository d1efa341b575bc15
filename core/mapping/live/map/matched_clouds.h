#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/page_store.h"
#include "core/cloud/packed_cloud.h"
#include "core/cloud/scan.h"

namespace leitstand {

/// What is matched of a key scan. Any thread.
class MatchedCloud {
public:
    /// Stays in memory.
    explicit MatchedCloud(const PointCloud& cloud);
    ~MatchedCloud();
    MatchedCloud(const MatchedCloud&) = delete;
    MatchedCloud& operator=(const MatchedCloud&) = delete;

    /// Points; known without waiting for the disk. Empty: nobody has used it yet, and it is not made before.
    [[nodiscard]] std::optional<std::size_t> size() const;
    /// The cloud, bit for bit the same wherever it waited; read again where it is out of memory.
    [[nodiscard]] PointCloud unpacked() const;
    /// Bytes of memory that it takes now.
    [[nodiscard]] std::size_t memory() const;

private:
    friend class MatchedClouds;
    struct Shelf;
    struct Place;
    /// @p cloud: null: it is made when it is used first.
    MatchedCloud(const PointCloud* cloud, std::shared_ptr<Shelf> shelf, std::function<PointCloud()> again);

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
    /// One that @p make makes when it is used first: of most scans of an earlier map nothing is ever matched.
    [[nodiscard]] MatchedCloudPtr promise(std::function<PointCloud()> make) const;

private:
    std::shared_ptr<MatchedCloud::Shelf> m_shelf;
};

}  // namespace leitstand
