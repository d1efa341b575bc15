#include "tests/hall/hall.h"

#include <memory>
#include <stdexcept>
#include <string>

#include "core/io/clouds/uos.h"
#include "core/mapping/scan_preparation.h"

namespace leitstand::test {

std::vector<ScanPtr> hallScans(const std::filesystem::path& folder) {
    std::vector<ScanPtr> scans;
    for (const char* name : {"scan000.3d", "scan001.3d", "scan002.3d"}) {
        auto reading = readUosScan(folder / name);
        if (!reading) throw std::runtime_error(reading.error().text);
        scans.push_back(labelled(std::make_shared<const Scan>(std::move(reading).value().scan)));
    }
    return scans;
}

Pose odometryStep(const std::vector<ScanPtr>& scans, std::size_t i) {
    return scans[i]->sensorInOdom.inverse() * scans[i + 1]->sensorInOdom;
}

Pose poseFromRows(const std::array<double, 12>& rows) {
    Pose pose = Pose::Identity();
    for (int i = 0; i < 12; ++i) pose.matrix()(i / 4, i % 4) = rows[static_cast<std::size_t>(i)];
    return orthonormalised(pose);
}

}  // namespace leitstand::test
