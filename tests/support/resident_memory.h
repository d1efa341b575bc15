#pragma once

#include <fstream>
#include <string>

namespace leitstand::test {

/// What this process has in memory; 0 where the system does not tell [MB].
[[nodiscard]] inline double residentMegabytes() {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        double kibibytes = 0.0;
        if (word == "VmRSS:" && status >> kibibytes) return kibibytes * 1024.0 / 1e6;
    }
    return 0.0;
}

}  // namespace leitstand::test
