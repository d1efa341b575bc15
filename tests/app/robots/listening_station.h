#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <sys/types.h>

#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"

namespace leitstand::test {

/// What a station has of a stream since it began.
struct HeardStream {
    std::uint64_t arrived = 0, lost = 0;  ///< [samples], by the writer's numbers
    double rate = 0.0;                    ///< over the last seconds [Hz]
};

/// A station that is a process, listens to both shipped robots and tells what it hears.
class ListeningStation {
public:
    /// @p more: as of the program listening_station.
    ListeningStation(const std::filesystem::path& folder, const TestDomain& domain,
                     std::vector<std::string> more = {"--interface", "lo"});

    [[nodiscard]] std::string state(const std::string& robot) const;   ///< of its link, as told last
    [[nodiscard]] std::map<std::string, HeardStream> streams() const;  ///< steady ones by topic, as told last
    [[nodiscard]] bool receives(const std::vector<std::string>& topics) const;  ///< something of each
    int end(int number);  ///< with this signal; its exit code, -1 when the signal ended it
    [[nodiscard]] std::string out() const { return m_process.out(); }
    [[nodiscard]] pid_t id() const { return m_process.id(); }

private:
    [[nodiscard]] std::string reported() const;  ///< what it said last, whole

    ChildProcess m_process;
};

}  // namespace leitstand::test
