#pragma once

#include <QByteArray>

#include "core/base/time.h"

namespace leitstand {

/// Returns @p bytes, which are a PDF, with its dates (in info and XMP) set to @p created. The identities
/// (/ID, XMP's uuid) become a hash of the content, so equal contents give equal bytes. Each value keeps its
/// length, so the table of objects remains valid. A date or identity of an unknown form is not changed.
[[nodiscard]] QByteArray withIdentity(QByteArray bytes, Time created);

}  // namespace leitstand
