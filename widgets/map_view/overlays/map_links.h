#pragma once

#include <cstdint>
#include <span>

class QPainter;

namespace leitstand {

class MapProjection;
struct OverlayStyle;
struct SceneContent;

/// Two key scans that see the same place, as detected or as an operator said.
struct MapLink {
    enum class Standing : std::uint8_t {
        Counts,   ///< the map uses it
        Open,     ///< it is an open question, or was undone
        Refused,  ///< somebody decided that it is not the same place
    };
    std::uint64_t from = 0, to = 0;  ///< MapScan::id
    Standing standing = Standing::Counts;

    bool operator==(const MapLink&) const = default;
};

/// Paints @p links as lines between the positions of their scans: solid for Counts, dashed for Open, dotted
/// for Refused.
void paintLinks(QPainter& painter, const MapProjection& projection, const SceneContent& content,
                std::span<const MapLink> links, const OverlayStyle& style);

}  // namespace leitstand
