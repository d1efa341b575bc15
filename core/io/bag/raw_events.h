#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand {

struct RawEvent;

/// Calls @p take for each event of @p bag that matches @p query, in order. Stops when @p take returns false
/// or @p progress is cancelled. @p progress shows how much of the log was read. @p take may move content out
/// of the event.
void forEachRaw(BagReader& bag, const BagQuery& query, const std::function<bool(RawEvent&)>& take,
                const Progress& progress = {});

}  // namespace leitstand
