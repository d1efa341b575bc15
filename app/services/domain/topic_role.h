#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/services/domain/seen_topic.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// Returns the role of @p topic; empty: the station does not use it. Sets @p remark to the reason, or to what
/// the user should check.
[[nodiscard]] std::optional<StreamRole> roleOf(const SeenTopic& topic, std::string& remark);

/// Whether @p topic carries pictures of depths, raw or as compressed_depth_image_transport sends them. JPEGs
/// of depths are of no use.
[[nodiscard]] bool isOfDepths(const SeenTopic& topic);

/// Returns the last part of a name: "/kurt3d/odom" -> "odom".
[[nodiscard]] std::string_view leafOf(std::string_view name);

}  // namespace leitstand
