#pragma once

#include <cstdint>
#include <span>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Two key scans that were found, or said, to see the same place.
struct MapLink {
    enum class Standing : std::uint8_t {
        Counts,   ///< the map follows it
        Open,     ///< it was asked about, or taken back
        Refused,  ///< somebody said that it is not the same place
    };
    std::uint64_t from = 0, to = 0;  ///< MapScan::id
    Standing standing = Standing::Counts;

    bool operator==(const MapLink&) const = default;
};

/// @p links as lines between where their scans were taken: solid where they count, dashed where they are
/// open, dotted where they were refused.
void paintLinks(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                std::span<const MapLink> links, const OverlayStyle& style);

}  // namespace leitstand
