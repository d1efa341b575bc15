#pragma once

#include <QCoreApplication>

#include "app/window/commands/key_list.h"

namespace leitstand {

/// Keys and mouse gestures that are no commands of a menu (docs/operator.md, docs/review.md).
struct KeyColumns {
    Q_DECLARE_TR_FUNCTIONS(leitstand::KeyColumns)
public:
    [[nodiscard]] static KeyColumn live();
    [[nodiscard]] static KeyColumn review();
    [[nodiscard]] static KeyColumn mapByHand();
};

}  // namespace leitstand
