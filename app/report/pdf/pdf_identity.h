#pragma once

#include <QByteArray>

#include "core/base/time.h"

namespace leitstand {

/// Returns the PDF @p bytes with @p created as its dates (in its info and its XMP). Its identities (/ID,
/// XMP's uuid) become a hash of its content, so equal contents give equal bytes. The length of each value
/// stays, so the table of objects stays valid. A date or identity of an unknown form stays as it is.
[[nodiscard]] QByteArray withIdentity(QByteArray bytes, Time created);

}  // namespace leitstand
