#include "transport/dds/guid.h"

#include <fmt/format.h>

namespace leitstand {

std::string toString(const Guid& guid) {
    std::string text;
    for (std::size_t i = 0; i < guid.bytes.size(); ++i) {
        if (i != 0 && i % 4 == 0) text += '.';
        text += fmt::format("{:02x}", guid.bytes[i]);
    }
    return text;
}

}  // namespace leitstand
