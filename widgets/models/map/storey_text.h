#pragma once

#include <QString>

#include "core/mapping/storeys.h"

namespace leitstand {

/// What the storey of this number is called: "0", "+1", "−1".
[[nodiscard]] inline QString storeyText(int number) {
    return QString::fromStdString(storeyName(number));
}

}  // namespace leitstand
