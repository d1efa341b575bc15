#pragma once

#include <string>

namespace leitstand {

/// A grant as a station sees it.
struct GrantView {
    bool mine = false;                          ///< this station holds it
    bool asked = false;                         ///< this station requests it and waits
    bool silent = false;                        ///< the holder, another station, was not heard for 3 s
    std::string holder, holderTitle;            ///< who holds it, maybe this station; empty: nobody known
    std::string requestedBy, requestedByTitle;  ///< if this station holds it: its first requester
    std::string refusedBy;                      ///< who refused this station's last request
    std::string lostTo;  ///< who took the grant from this station; empty once it requests it again
    friend bool operator==(const GrantView&, const GrantView&) = default;
};

}  // namespace leitstand
