#include "tests/simulation/mapping/uos_registration.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/scan_source.h"
#include "core/io/clouds/uos.h"
#include "core/mapping/offline_mapper.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::simulation::test {

UosRegistration registeredFromUos(const MappedDrive& drive) {
    const leitstand::test::TemporaryFolder folder;
    for (std::size_t i = 0; i < drive.scans.size(); ++i) {
        const auto written = writeUosScan(folder / fmt::format("scan{:03}.3d", i), *drive.scans[i].scan);
        if (!written) throw std::runtime_error(written.error().text);
    }
    UosRegistration result;
    RegistrationSettings settings;
    settings.guess = GuessSource::Odometry;
    OfflineMapper mapper(settings);
    const auto files = listScans({folder.path()});
    for (const auto& file : files.value()) {
        auto reading = readScan(file).value();
        result.points += reading.scan.points.size();
        ++result.read;
        mapper.add(std::make_shared<const Scan>(std::move(reading.scan)));
    }
    const MapPtr map = mapper.map();
    if (map->scans.size() != drive.scans.size()) return result;
    // The map's frame is the first scan's, which leans as the robot did.
    const Pose mapInOdom = map->scans.front().scan->sensorInOdom;
    for (std::size_t i = 0; i < map->scans.size(); ++i)
        result.trajectory.found.push_back(mapInOdom * map->scans[i].poseInMap *
                                          drive.scans[i].sensorInBase.inverse());
    result.trajectory.truth = drive.live.truth;
    return result;
}

}  // namespace leitstand::simulation::test
