#include "core/event/scan_links.h"

namespace leitstand {

std::string toString(LinkKind kind) {
    switch (kind) {
        case LinkKind::Odometry:
            return "odometry";
        case LinkKind::Match:
            return "match";
        case LinkKind::Loop:
            return "loop";
        case LinkKind::Operator:
            return "operator";
        case LinkKind::Gravity:
            return "gravity";
        case LinkKind::Session:
            return "session";
        case LinkKind::Geo:
            return "geo";
    }
    return {};
}

}  // namespace leitstand
