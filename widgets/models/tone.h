#pragma once

#include <QtCore/qnamespace.h>

namespace leitstand {

/// How prominently something is shown. Text or shape says the same; colour only repeats it.
enum class Tone { Normal, Muted, Attention, Act };

/// Item role under which models return a Tone, as int.
inline constexpr int ToneRole = Qt::UserRole + 1;

}  // namespace leitstand
