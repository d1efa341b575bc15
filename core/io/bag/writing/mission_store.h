#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "core/io/bag/bag_storage.h"
#include "core/io/bag/writing/bag_store.h"

namespace leitstand::detail {

/// Begins a session in the mission's folder @p folder; see BagWriter::open().
[[nodiscard]] Result<std::unique_ptr<BagStore>> createStore(const std::filesystem::path& folder,
                                                            std::optional<BagStorage> storage);

}  // namespace leitstand::detail
