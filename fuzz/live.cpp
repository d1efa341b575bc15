#include "core/io/robot/brake_file.h"
#include "core/io/settings/last_station_file.h"
#include "fuzz/input_file.h"

/// What the station remembers from run to run: with what it was opened last, and results of brake tests.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const fuzz::InputFile file(data, size);
    const auto last = readLastStation(file.path());
    fuzz::require(!last || (last->domain >= 0 && last->domain <= 232), "a domain of DDS");
    for (const auto& [robot, result] : readBrakes(file.path()))
        fuzz::require(!robot.empty() && result.seconds >= 0.0, "results that make sense");
    return 0;
}
