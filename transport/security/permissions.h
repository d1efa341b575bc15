#pragma once

#include <string>

#include "core/base/time.h"
#include "transport/security/keys.h"

namespace leitstand {

/// Returns the rules of a secured domain (DDS-Security 1.1, 9.4.1.2). Nobody without an identity takes part.
/// Discovery and liveliness are encrypted, and so is every message as a whole. The writer of a command signs
/// it for each reader separately, so that nobody who may read commands can forge them.
[[nodiscard]] std::string governanceXml();

/// Returns what the owner of a certificate of @p subject may do (DDS-Security 1.1, 9.4.1.3) between @p from
/// and @p until. Both are widened by a day, since Fast DDS takes UTC for local time here. It reads the dates
/// of the certificate correctly, so these are the limits that count. @p subject is in the order of RFC 2253.
[[nodiscard]] std::string permissionsXml(const KeyRequest& request, const std::string& subject, Time from,
                                         Time until);

/// Returns @p text for use in XML: & < > " ' escaped, control characters left out.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace leitstand
