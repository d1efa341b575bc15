#include "transport/screen/place.h"

#include <random>

#include <fmt/format.h>

namespace leitstand::screen {

const std::uint64_t BytesHash::Seed = std::uint64_t(std::random_device()()) << 32 | std::random_device()();

std::string toString(const Address& address) {
    return fmt::format("{}.{}.{}.{}", address[12], address[13], address[14], address[15]);
}

}  // namespace leitstand::screen
