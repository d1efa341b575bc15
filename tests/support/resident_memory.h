#pragma once

#include <fstream>
#include <string>

#include <sys/types.h>
#include <unistd.h>

namespace leitstand::test {

/// What @p process, this one if none is named, has in memory; 0 where the system does not tell, and once it
/// has ended [MB].
[[nodiscard]] inline double residentMegabytes(pid_t process = getpid()) {
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string word; status >> word;) {
        double kibibytes = 0.0;
        if (word == "VmRSS:" && status >> kibibytes) return kibibytes * 1024.0 / 1e6;
    }
    return 0.0;
}

}  // namespace leitstand::test
