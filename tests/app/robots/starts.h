#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "app/services/station/station.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/net/radio_link.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {

struct StartSettings {
    int runs = 20;
    std::uint32_t seed = 1;
    double atMost = 3.0;  ///< until all is heard, from when the last of the three is there [s]
    bool keys = false;
    double loss = 0.0;   ///< share of all datagrams between the robot and the others, both ways
    bool stock = false;  ///< a stock robot, on Cyclone DDS
    bool added = false;  ///< the recorder is told no robot, and the station takes the robot in meanwhile
    /// What goes on in a start's domain from before the first starts until all ended; it ends with what is
    /// returned.
    std::function<std::shared_ptr<void>(int domain)> meanwhile = {};
};

/// Robot, recorder and station that start in an order and with offsets of chance: who has not heard what, and
/// how long it took until each heard everything.
class Starts {
public:
    explicit Starts(const StartSettings& settings);
    /// Returns after how many seconds all was heard, the median.
    double run();

private:
    /// What of one start runs.
    struct Run {
        std::filesystem::path mission, desk;  ///< folders, of the recorder and of the station
        std::string when;                     ///< who started when, in words
        std::unique_ptr<ChildProcess> robot, recorder;
        std::unique_ptr<Station> station;
        std::vector<std::string> atDesk, recorded;  ///< topics that station and recorder have not heard yet
    };
    enum class Part : std::uint8_t { Robot, Recorder, Desk, Adding };

    void once(int number);
    [[nodiscard]] std::vector<Part> order();
    void start(Part part, const TestDomain& domain, Run& run) const;
    [[nodiscard]] std::unique_ptr<ChildProcess> robot(const TestDomain& domain) const;
    [[nodiscard]] std::unique_ptr<ChildProcess> recorder(const TestDomain& domain, const Run& run) const;
    [[nodiscard]] std::unique_ptr<Station> desk(const TestDomain& domain, const Run& run, bool alone) const;
    [[nodiscard]] std::vector<std::string> keysOf(const std::string& who) const;
    void look(Run& run) const;
    /// Whether all is heard in twice the time that is asked; @p course: how many topics were not, and since
    /// when.
    [[nodiscard]] bool receives(Run& run, std::string& course) const;

    const StartSettings m_settings;
    std::mt19937 m_random;
    const TemporaryFolder m_folder;
    RobotDescription m_robot;
    std::optional<RadioLink> m_radio;
    std::optional<InNamespace> m_here;  // on the station's side of the radio
    std::vector<double> m_seconds;
};

}  // namespace leitstand::test
