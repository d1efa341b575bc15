#pragma once

#include <QString>

#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// "Scanner", "Camera", "Infrared".
[[nodiscard]] QString sensorText(SearchSensor sensor);

}  // namespace leitstand
