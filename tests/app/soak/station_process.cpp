#include "tests/app/soak/station_process.h"

#include <fstream>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/resident_memory.h"

namespace leitstand::test {
namespace {

int entriesOf(const std::string& folder) {
    std::error_code ended;
    int count = 0;
    for (std::filesystem::directory_iterator one(folder, ended), end; !ended && one != end;
         one.increment(ended))
        ++count;
    return count;
}

}  // namespace

StationProcess::StationProcess(const std::filesystem::path& folder, int domain)
    : m_folder(folder),
      m_process(program("leitstand"),
                {"--live", "--robot", "kurt3d", "crawler", "--interface", "lo", "--domain",
                 std::to_string(domain), "--mission", (folder / "mission").string()},
                {"QT_QPA_PLATFORM=offscreen", "XDG_CONFIG_HOME=" + (folder / "config").string(),
                 "XDG_DATA_HOME=" + (folder / "data").string()}) {}

double StationProcess::residentMegabytes() const {
    return test::residentMegabytes(m_process.id());
}

int StationProcess::threads() const {
    std::error_code ended;
    int count = 0;
    for (std::filesystem::directory_iterator one(fmt::format("/proc/{}/task", m_process.id()), ended), end;
         !ended && one != end; one.increment(ended)) {
        std::string name;
        std::getline(std::ifstream(one->path() / "comm"), name);
        if (!name.empty() && name != "Thread (pooled)") ++count;
    }
    return count;
}

int StationProcess::descriptors() const {
    return entriesOf(fmt::format("/proc/{}/fd", m_process.id()));
}

double StationProcess::processorSeconds() const {
    return secondsUsedBy(m_process.id());
}

}  // namespace leitstand::test
