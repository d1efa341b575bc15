#include <string>

#include "core/io/settings/station_file.h"
#include "fuzz/input_file.h"

/// Who a station is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto station = parseStation(text);
    if (!station) return 0;
    fuzz::require(!station->id.empty() && station->id.size() <= 64, "an identity");
    fuzz::require(station->held.size() <= 256, "few grants");
    return 0;
}
