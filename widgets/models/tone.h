#pragma once

#include <QtCore/qnamespace.h>

namespace leitstand {

/// How loud something is said; text or shape says the same, colour only repeats it.
enum class Tone { Normal, Muted, Attention, Act };

/// Item role under which models hand out a Tone, as int.
inline constexpr int ToneRole = Qt::UserRole + 1;

}  // namespace leitstand
