#pragma once

#include <csignal>
#include <filesystem>

#include "tests/support/child_process.h"

namespace leitstand::test {

/// The station as operators start it, on both shipped robots: a process with the real window, drawn nowhere.
/// Nothing of it is left outside of a folder.
class StationProcess {
public:
    /// Records into @p folder / "mission"; on the loopback device.
    StationProcess(const std::filesystem::path& folder, int domain);

    [[nodiscard]] std::filesystem::path mission() const { return m_folder / "mission"; }
    [[nodiscard]] double residentMegabytes() const;  ///< 0 when it has ended
    [[nodiscard]] double processorSeconds() const;   ///< used so far; infinite when it has ended
    /// That it has now, but for those of Qt's pools, two a processor at most: scaling a picture starts them,
    /// and they stay for half a minute.
    [[nodiscard]] int threads() const;
    [[nodiscard]] int descriptors() const;  ///< that it has open now
    [[nodiscard]] std::string out() const { return m_process.out(); }
    [[nodiscard]] pid_t id() const { return m_process.id(); }
    /// Asks it to end; waitForEnd() tells its exit code.
    void terminate() const { m_process.signal(SIGTERM); }
    [[nodiscard]] int waitForEnd() { return m_process.wait(); }

private:
    std::filesystem::path m_folder;
    ChildProcess m_process;
};

}  // namespace leitstand::test
