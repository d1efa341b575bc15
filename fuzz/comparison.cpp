#include <string>

#include "core/io/settings/comparison_file.h"
#include "fuzz/input_file.h"

/// A comparison of maps that was kept.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto comparison = parseComparison(text, "comparison.json");
    if (!comparison) return fuzz::requireNamed(comparison.error(), "comparison.json");
    for (const ComparedScan& scan : comparison->scans)
        fuzz::require(scan.recorded.matrix().allFinite() && scan.again.matrix().allFinite(), "poses");
    return 0;
}
