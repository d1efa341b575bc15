#include "tests/core/mapping/live/slices.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/event/motion_samples.h"

namespace leitstand::test {

using std::chrono::milliseconds;

CloudSample SliceMaker::slice(int number) const {
    CloudSample cloud;
    cloud.header = {stampOf(number), "laser"};
    cloud.rows = Rows;
    cloud.columns = Columns;
    for (int row = 0; row < Rows; ++row) {
        const int raw = number * Rows + row;
        const double heading = degrees(360.0 / RowsATurn) * (firstRow + raw);
        for (int column = 0; column < Columns; ++column) {
            const double elevation = degrees(-30.0 + 5.0 * column);
            cloud.points.emplace_back(
                Eigen::Vector3d(3.0 * std::cos(heading), 3.0 * std::sin(heading), 3.0 * std::tan(elevation))
                    .cast<float>());
            cloud.intensities.push_back(static_cast<float>(raw));
            cloud.times.push_back(std::chrono::nanoseconds(Slice * row / Rows).count());
        }
    }
    return cloud;
}

std::vector<CloudSample> SliceMaker::slices(int first, int last) const {
    std::vector<CloudSample> made;
    for (int i = first; i < last; ++i) made.push_back(slice(i));
    return made;
}

OdometrySample odometryAt(Time stamp, const Pose& baseInOdom) {
    OdometrySample sample;
    sample.header = {stamp, "odom"};
    sample.baseInOdom = baseInOdom;
    return sample;
}

std::vector<int> rowsIn(const std::vector<LiveScan>& scans) {
    std::vector<int> rows;
    for (const LiveScan& live : scans) {
        for (std::size_t i = 0; i < live.scan->intensities.size(); i += SliceMaker::Columns)
            rows.push_back(static_cast<int>(live.scan->intensities[i]));
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

std::vector<int> allRows(int count) {
    std::vector<int> rows(static_cast<std::size_t>(count));
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

Pose Operation::poseAt(Time stamp) const {
    const double time = std::chrono::duration<double>(stamp.time_since_epoch()).count() - 1000.0;
    return poseFrom({speed * time, 0, 0}, 0, 0, std::remainder(turnRate * time, 2.0 * 3.14159265358979));
}

void Operation::until(Time end) {
    for (; now < end; now += milliseconds(10)) {
        if (now >= m_next) {
            m_next += milliseconds(50);
            if (odometry) cutter.add(odometryAt(now + robotAhead, poseAt(now)), now);
        }
        for (LiveScan& scan : cutter.take(now)) scans.push_back(std::move(scan));
    }
}

}  // namespace leitstand::test
