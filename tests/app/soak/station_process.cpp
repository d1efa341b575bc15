#include "tests/app/soak/station_process.h"

#include <fstream>
#include <string>

#include <fmt/format.h>

#include "tests/support/places.h"
#include "tests/support/process.h"

namespace leitstand::test {

StationProcess::StationProcess(const std::filesystem::path& folder, int domain)
    : m_folder(folder),
      m_process(program("leitstand"),
                {"--live", "--robot", "kurt3d", "crawler", "--interface", "lo", "--domain",
                 std::to_string(domain), "--mission", (folder / "mission").string()},
                {"QT_QPA_PLATFORM=offscreen", "XDG_CONFIG_HOME=" + (folder / "config").string(),
                 "XDG_DATA_HOME=" + (folder / "data").string()}) {}

double StationProcess::residentMegabytes() const {
    std::ifstream status(fmt::format("/proc/{}/status", m_process.id()));
    for (std::string word; status >> word;) {
        double kibibytes = 0.0;
        if (word == "VmRSS:" && status >> kibibytes) return kibibytes * 1024.0 / 1e6;
    }
    return 0.0;
}

double StationProcess::processorSeconds() const {
    return secondsUsedBy(m_process.id());
}

}  // namespace leitstand::test
