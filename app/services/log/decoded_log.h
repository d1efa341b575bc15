#pragma once

#include <functional>

#include "app/services/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/io/bag/bag_reader.h"

namespace leitstand {

struct Event;

/// Decodes the events of @p bag that @p query selects and calls @p take with each result, in order.
/// @p progress: as for forEachRaw(). Here, a query without topics selects nothing.
void forEachEvent(BagReader& bag, EventDecoder& decoder, const BagQuery& query,
                  const std::function<void(const Event&)>& take, const Progress& progress = {});

}  // namespace leitstand
