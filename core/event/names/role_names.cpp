#include "core/event/stream_role.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace leitstand {

bool isCommand(StreamRole role) {
    return std::ranges::find(CommandRoles, role) != CommandRoles.end();
}

std::span<const StreamRole> allStreamRoles() {
    static const std::vector<StreamRole> all = [] {
        std::vector<StreamRole> roles;
        for (int number = 0; number <= std::numeric_limits<std::uint8_t>::max(); ++number)
            if (const auto role = static_cast<StreamRole>(number); !nameOf(role).empty())
                roles.push_back(role);
        return roles;
    }();
    return all;
}

std::string toString(StreamRole role) {
    return std::string(nameOf(role));
}

}  // namespace leitstand
