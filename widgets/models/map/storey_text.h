#pragma once

#include <QString>

#include "core/mapping/storeys.h"

namespace leitstand {

/// Returns the name of the storey with @p number: "0", "+1", "−1".
[[nodiscard]] inline QString storeyText(int number) {
    return QString::fromStdString(storeyName(number));
}

}  // namespace leitstand
