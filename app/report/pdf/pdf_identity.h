#pragma once

#include <QByteArray>

#include "core/base/time.h"

namespace leitstand {

/// The PDF @p bytes with @p created as its dates (of its info and its XMP), and with identities (/ID, XMP's
/// uuid) that are a hash of its content: equal contents make equal bytes. Nothing becomes longer or shorter,
/// so that its table of objects stays true; a date or identity in a form that is not known is left as it is.
[[nodiscard]] QByteArray withIdentity(QByteArray bytes, Time created);

}  // namespace leitstand
