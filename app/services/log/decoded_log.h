#pragma once

#include <functional>

#include "app/services/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/event/event.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand {

/// Calls @p take for what @p decoder makes of the events of @p bag that @p query asks for, in order;
/// @p progress as of forEachRaw(). A query without topics is of none here.
void forEachEvent(BagReader& bag, EventDecoder& decoder, const BagQuery& query,
                  const std::function<void(const Event&)>& take, const Progress& progress = {});

}  // namespace leitstand
