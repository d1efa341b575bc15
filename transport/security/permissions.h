#pragma once

#include <string>

#include "core/base/time.h"
#include "transport/security/keys.h"

namespace leitstand {

/// The rules of a secured domain (DDS-Security 1.1, 9.4.1.2): nobody without an identity takes part; what is
/// there and who is alive is encrypted, and so is every message as a whole; whoever writes a command signs it
/// for each reader apart, so that nobody who may read commands can forge them.
[[nodiscard]] std::string governanceXml();

/// What the owner of a certificate of @p subject may do (DDS-Security 1.1, 9.4.1.3) between @p from and
/// @p until, which are widened by a day: Fast DDS takes UTC for local time here, and the certificate, which
/// it reads properly, is the limit that counts. @p subject is in the order of RFC 2253.
[[nodiscard]] std::string permissionsXml(const KeyRequest& request, const std::string& subject, Time from,
                                         Time until);

/// @p text so that it stands in XML as it is: & < > " ' escaped, control characters left out.
[[nodiscard]] std::string xmlEscaped(const std::string& text);

}  // namespace leitstand
