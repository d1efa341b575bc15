#include "core/io/clouds/xyz.h"
#include "fuzz/input_file.h"
#include "fuzz/scan_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    fuzz::checkReading(readXyz(fuzz::InputFile(data, size).path()));
    return 0;
}
