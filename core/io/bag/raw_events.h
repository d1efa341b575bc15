#pragma once

#include <functional>

#include "core/base/progress.h"
#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand {

/// Calls @p take for each event of @p bag that @p query asks for, in order, until it returns false, or
/// @p progress, which shows how much of the log is read, is cancelled; @p take may keep the event.
void forEachRaw(BagReader& bag, const BagQuery& query, const std::function<bool(RawEvent&)>& take,
                const Progress& progress = {});

}  // namespace leitstand
