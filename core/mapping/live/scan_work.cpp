#include "core/mapping/live/scan_work.h"

#include <algorithm>

#include "core/scan/labels.h"
#include "core/scan/normals.h"
#include "core/scan/outliers.h"
#include "core/scan/range_filter.h"
#include "core/scan/voxel_grid.h"

namespace leitstand {

ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                    const LiveSettings& settings) {
    Scan scan = *live.scan;
    leaveOutBody(scan, body, live.sensorInBase);
    leaveOutCropped(scan, settings.crop, scanInMap);
    scan = withoutMixedPixels(std::move(scan));
    LabelSettings labels;
    labels.up = live.up;
    scan.labels = labelScan(scan, labels);
    std::vector<Eigen::Vector3f> normals;
    if (scan.organised()) normals = gridNormals(scan);
    const PointCloud all = pointsInRange(scan, normals, settings.match.minRange, settings.match.maxRange);
    ReadyScan ready;
    ready.reduced = voxelGrid(all, settings.match.reduce, VoxelPoint::Centroid);
    if (ready.reduced.normals.empty()) ready.reduced.normals = knnNormals(ready.reduced.points);
    const PointCloud thinned = voxelGrid(all, settings.kept);
    scan.rows = scan.columns = 0;
    scan.intensities.clear();
    scan.points = thinned.points;
    scan.labels = thinned.labels;
    ready.scan = std::make_shared<const Scan>(std::move(scan));
    return ready;
}

Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share) {
    const Eigen::Vector3d upInMap = scanInMap.linear() * up;
    const auto full = Eigen::Quaterniond::FromTwoVectors(upInMap, Eigen::Vector3d::UnitZ());
    Pose result = scanInMap;
    result.linear() =
        (Eigen::Quaterniond::Identity().slerp(share, full) * Eigen::Quaterniond(scanInMap.linear()))
            .normalized()
            .toRotationMatrix();
    return result;
}

double newGround(const PointCloud& cloud, const LocalMap& local, const Pose& scanInMap, double distance) {
    if (cloud.points.empty()) return 0.0;
    if (!local.search) return 1.0;
    const Eigen::Isometry3f motion = scanInMap.cast<float>();
    const auto bound = static_cast<float>(distance * distance);
    const auto fresh =
        std::count_if(cloud.points.begin(), cloud.points.end(), [&](const Eigen::Vector3f& point) {
            return !local.search->nearest(motion * point, Label::Unlabelled, bound).found();
        });
    return static_cast<double>(fresh) / static_cast<double>(cloud.size());
}

Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
            const std::optional<Eigen::Vector3d>& up, const LiveSettings& settings) {
    Match result;
    result.scanInMap = guess;
    const auto doubt = [&](ScanDoubt one) { result.doubts |= static_cast<std::uint8_t>(one); };
    if (static_cast<int>(cloud.size()) < settings.fit.leastPoints) doubt(ScanDoubt::Points);
    if (!local.search || cloud.points.empty()) {
        doubt(ScanDoubt::Overlap);
        return result;
    }
    IcpSettings icp;
    icp.maxDistances = step.known ? settings.match.near : settings.match.wide;
    icp.maxIterations = settings.match.maxIterations;
    icp.threads = 1;
    icp.minStep = 5e-4;
    result.icp = align(local.cloud, *local.search, cloud, guess, icp);
    const FitSettings& fit = settings.fit;
    if (result.icp.stop == IcpStop::Degenerate) {
        doubt(ScanDoubt::Certainty);
        return result;
    }
    if (!result.icp.converged) doubt(ScanDoubt::Diverged);
    if (result.icp.overlap < fit.leastOverlap) doubt(ScanDoubt::Overlap);
    if (result.icp.rms > fit.mostResidual) doubt(ScanDoubt::Residual);
    if (result.icp.certainty < fit.leastCertainty) doubt(ScanDoubt::Certainty);
    const double jump = distanceBetween(guess, result.icp.pose), turn = angleBetween(guess, result.icp.pose);
    if (step.known && (jump > fit.jump + fit.jumpOfWay * step.way ||
                       turn > fit.turn + fit.turnOfTurn * step.turn + fit.turnOfWay * step.way))
        doubt(ScanDoubt::Jump);
    if (result.doubts != 0) return result;  // as odometry says
    result.scanInMap = up ? levelled(result.icp.pose, *up, settings.match.levelShare) : result.icp.pose;
    return result;
}

}  // namespace leitstand
