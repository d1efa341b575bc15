#include "core/event/find_sample.h"

#include <string_view>

namespace leitstand {

std::string nameOf(FindSample::Kind kind, std::uint32_t number) {
    constexpr std::string_view Letters = "VHQO";
    return Letters[static_cast<std::size_t>(kind)] + std::to_string(number);
}

}  // namespace leitstand
