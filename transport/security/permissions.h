#pragma once

#include <string>

#include "core/base/time.h"
#include "transport/security/keys.h"

namespace leitstand {

/// Returns the rules of a secured domain (DDS-Security 1.1, 9.4.1.2). Only owners of an identity take part.
/// Discovery and liveliness are encrypted, and every message is encrypted as a whole. The writer of a command
/// signs it for each reader separately, so that nobody who may read commands can forge them.
[[nodiscard]] std::string governanceXml();

/// Returns what the owner of a certificate with @p subject may do (DDS-Security 1.1, 9.4.1.3) between @p from
/// and @p until. Both are extended by a day, since Fast DDS treats these UTC times as local time. It reads
/// the dates of the certificate correctly, so those limit the use. @p subject: in the order of RFC 2253.
[[nodiscard]] std::string permissionsXml(const KeyRequest& request, const std::string& subject, Time from,
                                         Time until);

/// Returns @p text for use in XML: & < > " ' are escaped, control characters are removed.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace leitstand
