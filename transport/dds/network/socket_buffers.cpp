#include "transport/dds/network/socket_buffers.h"

#include <fstream>
#include <string_view>

#include <fmt/format.h>

namespace leitstand::detail {

std::vector<std::string> socketBufferWarnings(const std::filesystem::path& folder) {
    std::vector<std::string> warnings;
    const auto check = [&](std::string_view name, std::string_view consequence) {
        std::ifstream in(folder / name);
        std::uint64_t limit = 0;
        if (!(in >> limit) || limit >= SocketBufferSize) return;
        warnings.push_back(
            fmt::format("net.core.{0} is {1} bytes: {2}. Lift it with: sudo sysctl -w net.core.{0}={3}", name,
                        limit, consequence, SocketBufferSize));
    };
    check("rmem_max", "large scans and pictures will be lost or late");
    check("wmem_max", "large samples will be sent in fits and starts");
    return warnings;
}

}  // namespace leitstand::detail
