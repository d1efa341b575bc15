#pragma once

#include <QString>

#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// Text for a sensor: "Scanner", "Camera", "Infrared".
[[nodiscard]] QString sensorText(SearchSensor sensor);

}  // namespace leitstand
