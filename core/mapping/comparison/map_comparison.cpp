#include "core/mapping/comparison/map_comparison.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/time.h"
#include "core/cloud/search/search.h"
#include "core/mapping/offline_mapper.h"
#include "core/mapping/scan_preparation.h"

namespace leitstand {
namespace {

constexpr double RegisteringShare = 0.8;  ///< of the work, roughly

ScanFit fitOf(const Search& target, const PointCloud& source, const Pose& sourceInTarget) {
    constexpr float Bound = static_cast<float>(IcpResult::OverlapDistance * IcpResult::OverlapDistance);
    const Eigen::Isometry3f pose = sourceInTarget.cast<float>();
    double sum = 0.0;
    std::size_t met = 0;
    for (const Eigen::Vector3f& point : source.points) {
        const Neighbour found = target.nearest(pose * point, Label::Unlabelled, Bound);
        if (!found.found()) continue;
        ++met;
        sum += static_cast<double>(found.squaredDistance);
    }
    ScanFit fit;
    fit.overlap = static_cast<double>(met) / static_cast<double>(source.size());
    fit.rms = met == 0 ? 0.0 : std::sqrt(sum / static_cast<double>(met));
    return fit;
}

/// Measures each scan of one robot against the one before it. Returns false when cancelled.
bool measure(std::vector<ComparedScan*>& scans, const RegistrationSettings& settings,
             const Progress& progress) {
    std::unique_ptr<Search> search;
    const ComparedScan* before = nullptr;
    for (ComparedScan* one : scans) {
        if (progress.cancelled()) return false;
        const PointCloud cloud = prepared(*labelled(one->scan), settings);
        if (cloud.points.empty()) continue;
        if (before != nullptr) {
            one->fitRecorded = fitOf(*search, cloud, before->recorded.inverse() * one->recorded);
            one->fitAgain = fitOf(*search, cloud, before->again.inverse() * one->again);
        }
        search = makeSearch(cloud, SearchMethod::KdTree);
        before = one;
    }
    return true;
}

/// Returns the scans of one robot with odometry that leads from each to the next. Where odometry restarted
/// between two, since the robot was restarted or carried, the recorded map gives the step.
std::vector<ScanPtr> withWholeOdometry(const std::vector<ComparedScan*>& scans) {
    constexpr double Jump = 1.0, Turn = degrees(45);  // between key scans no odometry errs so much [m], [rad]
    std::vector<ScanPtr> whole;
    Pose shift = Pose::Identity();  // from the frame of odometry now to its first one
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const Scan& scan = *scans[i]->scan;
        if (i > 0 && scan.hasOdometry && whole.back()->hasOdometry) {
            const Pose& before = whole.back()->sensorInOdom;
            const Pose recorded = before * scans[i - 1]->recorded.inverse() * scans[i]->recorded;
            const Pose reported = shift * scan.sensorInOdom;
            if (distanceBetween(reported, recorded) > Jump || angleBetween(reported, recorded) > Turn)
                shift = recorded * scan.sensorInOdom.inverse();
        }
        if (!scan.hasOdometry || shift.isApprox(Pose::Identity())) {
            whole.push_back(scans[i]->scan);
            continue;
        }
        auto moved = std::make_shared<Scan>(scan);
        moved->sensorInOdom = shift * scan.sensorInOdom;
        whole.push_back(std::move(moved));
    }
    return whole;
}

/// Registers the scans of one robot. Returns false when cancelled.
bool registerScans(std::vector<ComparedScan*>& scans, const RegistrationSettings& settings,
                   const Progress& progress, std::size_t done, std::size_t all) {
    OfflineMapper mapper(settings);
    for (const ScanPtr& scan : withWholeOdometry(scans)) {
        const Progress step{[&](double fraction) {
                                progress.done(RegisteringShare * (static_cast<double>(done) + fraction) /
                                              static_cast<double>(all));
                            },
                            progress.stop};
        if (!mapper.add(scan, step)) return false;
        ++done;
    }
    const MapPtr map = mapper.map();
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const MapScan& made = map->scans[i];
        scans[i]->again = scans.front()->recorded * made.poseInMap;
        scans[i]->uncertainAgain = made.registered && (!made.icp.converged || !made.icp.certain());
    }
    return true;
}

struct Sum {
    double rms = 0.0, overlap = 0.0;
    int fits = 0;
    void add(const std::optional<ScanFit>& fit) {
        if (!fit) return;
        rms += fit->rms;
        overlap += fit->overlap;
        ++fits;
    }
    void into(MapFigures& figures) const {
        if (fits == 0) return;
        figures.rms = rms / fits;
        figures.overlap = overlap / fits;
    }
};

/// Returns @p scan in grey and without the ceiling, which would hide the rest.
ScanPtr greyed(const Scan& scan) {
    auto grey = std::make_shared<Scan>(scan);
    grey->rows = grey->columns = 0;
    grey->points.clear();
    grey->labels.clear();
    grey->intensities.clear();
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (i < scan.labels.size() && scan.labels[i] == Label::Ceiling) continue;
        grey->points.push_back(scan.points[i]);
        grey->labels.push_back(Label::Unlabelled);
    }
    return grey;
}

}  // namespace

std::optional<MapComparison> registeredAgain(std::vector<ComparedScan> scans,
                                             const RegistrationSettings& settings, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    MapComparison whole;
    whole.settings = settings;
    whole.scans = std::move(scans);
    std::map<std::string, std::vector<ComparedScan*>> robots;
    for (ComparedScan& one : whole.scans) robots[one.robot].push_back(&one);
    std::size_t done = 0;
    for (auto& [robot, of] : robots) {
        if (!registerScans(of, settings, progress, done, whole.scans.size())) return std::nullopt;
        done += of.size();
    }
    whole.again.seconds = toSeconds(std::chrono::steady_clock::now() - start);
    for (auto& [robot, of] : robots) {
        if (!measure(of, settings, progress)) return std::nullopt;
    }
    sumUp(whole);
    progress.done(1.0);
    return whole;
}

void sumUp(MapComparison& whole) {
    Sum recorded, again;
    whole.recorded.uncertain = whole.again.uncertain = 0;
    whole.recorded.path = whole.again.path = 0.0;
    whole.meanMoved = whole.mostMoved = whole.meanTurned = whole.mostTurned = 0.0;
    std::map<std::string, const ComparedScan*> before;
    for (const ComparedScan& one : whole.scans) {
        recorded.add(one.fitRecorded);
        again.add(one.fitAgain);
        whole.recorded.uncertain += one.uncertainRecorded ? 1 : 0;
        whole.again.uncertain += one.uncertainAgain ? 1 : 0;
        const double moved = distanceBetween(one.recorded, one.again);
        const double turned = angleBetween(one.recorded, one.again);
        whole.meanMoved += moved / static_cast<double>(whole.scans.size());
        whole.meanTurned += turned / static_cast<double>(whole.scans.size());
        whole.mostMoved = std::max(whole.mostMoved, moved);
        whole.mostTurned = std::max(whole.mostTurned, turned);
        if (const ComparedScan* last = std::exchange(before[one.robot], &one)) {
            whole.recorded.path += distanceBetween(last->recorded, one.recorded);
            whole.again.path += distanceBetween(last->again, one.again);
        }
    }
    recorded.into(whole.recorded);
    again.into(whole.again);
}

MapPtr mapOf(const MapComparison& comparison, ComparedMap which) {
    auto map = std::make_shared<Map>();
    const auto add = [&](const ComparedScan& one, ScanPtr scan, const Pose& pose, bool uncertain) {
        MapScan shown;
        shown.scan = std::move(scan);
        shown.poseInMap = shown.guessInMap = pose;
        shown.id = one.id;
        shown.uncertain = uncertain;
        map->scans.push_back(std::move(shown));
    };
    for (const ComparedScan& one : comparison.scans) {
        if (which == ComparedMap::Recorded) add(one, one.scan, one.recorded, one.uncertainRecorded);
        if (which == ComparedMap::Both) add(one, greyed(*one.scan), one.recorded, false);
    }
    for (const ComparedScan& one : comparison.scans) {
        if (which != ComparedMap::Recorded) add(one, one.scan, one.again, one.uncertainAgain);
    }
    return map;
}

}  // namespace leitstand
