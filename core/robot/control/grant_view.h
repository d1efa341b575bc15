#pragma once

#include <string>

namespace leitstand {

/// A grant as a station sees it.
struct GrantView {
    bool mine = false;                ///< this station holds it
    bool asked = false;               ///< this station requests it and waits
    bool silent = false;              ///< the holder is another station, which was not heard for 3 s
    std::string holder, holderTitle;  ///< who holds it, possibly this station; empty: nobody is known
    std::string requestedBy, requestedByTitle;  ///< first station that requests it, if this station holds it
    std::string refusedBy;                      ///< station that refused this station's last request
    /// Station that took the grant from this station; empty after this station requests it again.
    std::string lostTo;
    friend bool operator==(const GrantView&, const GrantView&) = default;
};

}  // namespace leitstand
