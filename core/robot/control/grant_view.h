#pragma once

#include <string>

namespace leitstand {

/// A grant as a station sees it.
struct GrantView {
    bool mine = false;                          ///< this station holds it
    bool asked = false;                         ///< this station requests it and waits
    bool silent = false;                        ///< its holder was not heard for 3 s
    std::string holder, holderTitle;            ///< who holds it, also this station; empty: nobody known
    std::string requestedBy, requestedByTitle;  ///< of a grant of this station: its first requester
    std::string refusedBy;                      ///< who refused this station's last request
    std::string lostTo;                         ///< who holds what this station lost; until it requests again
    friend bool operator==(const GrantView&, const GrantView&) = default;
};

}  // namespace leitstand
