#include "core/mapping/offline_mapper.h"

#include <chrono>
#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mapping/metascan.h"
#include "core/mapping/motion/odometry_drift.h"
#include "core/mapping/motion/odometry_scale.h"
#include "core/mapping/scan_preparation.h"

namespace leitstand {
namespace {

/// Metascans of all points are thinned to this, a scanner's noise [m].
constexpr double FinestMetascan = 0.01;
/// IcpSettings::kernel: what voxels and borders of surfaces add to a scanner's noise counts little. This
/// halves the errors of scans' headings.
constexpr double Kernel = 4.0;
/// GuessPrior::openBelow: slats that look alike a hand farther on may hold a corridor's axis.
constexpr double OpenBelow = 0.15;
/// Shorter steps of odometry hold little information on its scale [m].
constexpr double LeastStep = 0.1;
/// Share of a scan's work that is done once it is prepared, for the progress.
constexpr double PreparedFraction = 0.3;

IcpSettings icpSettings(const RegistrationSettings& settings) {
    IcpSettings icp;
    icp.maxDistances = settings.maxDistances;
    icp.maxIterations = settings.maxIterations;
    icp.minimizer = settings.minimizer;
    icp.threads = settings.threads;
    // With all points, mixed pixels hang behind edges, and their deviation holds no information.
    if (settings.reduce > 0.0) icp.kernel = Kernel;
    return icp;
}

}  // namespace

struct OfflineMapper::State {
    explicit State(RegistrationSettings chosen)
        : settings(std::move(chosen)),
          metascan({settings.reduce > 0.0 ? settings.reduce : FinestMetascan, settings.search,
                    settings.epsilon}) {}

    /// Returns whether @p scan's guess is by odometry, from the scan before.
    [[nodiscard]] bool followsOdometry(const Scan& scan) const {
        return settings.guess == GuessSource::Odometry && scan.hasOdometry &&
               map.scans.back().scan->hasOdometry;
    }

    /// Returns where @p scan starts, in the map.
    [[nodiscard]] Pose guessOf(const Scan& scan) const {
        if (settings.guess == GuessSource::Poses && map.scans.size() < settings.guessPoses.size()) {
            const Pose& first = settings.guessPoses.front();
            return map.scans.empty() ? Pose::Identity()
                                     : first.inverse() * settings.guessPoses[map.scans.size()];
        }
        if (map.scans.empty()) return Pose::Identity();
        const MapScan& previous = map.scans.back();
        if (!followsOdometry(scan)) return previous.poseInMap;
        Pose step = stepOf(scan);
        step.translation() *= scale.factor();
        return previous.poseInMap * step;
    }

    /// Returns the step from the scan before to @p scan, by odometry.
    [[nodiscard]] Pose stepOf(const Scan& scan) const {
        return map.scans.back().scan->sensorInOdom.inverse() * scan.sensorInOdom;
    }

    /// Updates the scale of odometry by @p entry, the next scan, if surfaces hold all its directions.
    void learnScale(const MapScan& entry) {
        if (!entry.icp.converged || entry.icp.open > 0 || !followsOdometry(*entry.scan)) return;
        const double byOdometry = stepOf(*entry.scan).translation().norm();
        const double found = (map.scans.back().poseInMap.inverse() * entry.poseInMap).translation().norm();
        if (byOdometry > LeastStep) scale.add(byOdometry, found);
    }

    /// Returns odometry's prior for @p scan along directions that surfaces leave open; empty if the guess is
    /// not by odometry.
    [[nodiscard]] std::optional<GuessPrior> priorOf(const Scan& scan, const Pose& guessInMap) const {
        if (!followsOdometry(scan)) return std::nullopt;
        const Pose step = map.scans.back().poseInMap.inverse() * guessInMap;
        GuessPrior prior;
        prior.openBelow = OpenBelow;
        prior.deviation =
            OdometryDrift{}.deviation(step.translation().norm(), Eigen::AngleAxisd(step.linear()).angle());
        return prior;
    }

    /// Makes @p cloud the target of the next scan; an empty one is ignored.
    void setTarget(PointCloud cloud, const Pose& cloudInMap) {
        if (cloud.points.empty()) return;
        if (settings.reference == Reference::Map) {
            metascan.add(cloud, cloudInMap);
            return;
        }
        previousSearch.reset();
        previousCloud = std::move(cloud);
        targetInMap = cloudInMap;
        previousSearch = makeSearch(previousCloud, settings.search, settings.epsilon);
    }

    [[nodiscard]] const PointCloud& target() const {
        return settings.reference == Reference::Map ? metascan.cloud() : previousCloud;
    }

    /// Returns the search over target(); null before the first scan with points.
    [[nodiscard]] const Search* search() const {
        if (settings.reference != Reference::Map) return previousSearch.get();
        return metascan.cloud().points.empty() ? nullptr : &metascan.search();
    }

    RegistrationSettings settings;
    Map map;
    OdometryScale scale;
    PointCloud previousCloud;  // unless against the map
    std::unique_ptr<Search> previousSearch;
    Metascan metascan;  // in the map's frame
    Pose targetInMap = Pose::Identity();
};

OfflineMapper::OfflineMapper(RegistrationSettings settings)
    : m_state(std::make_unique<State>(std::move(settings))) {}
OfflineMapper::~OfflineMapper() = default;
OfflineMapper::OfflineMapper(OfflineMapper&&) noexcept = default;
OfflineMapper& OfflineMapper::operator=(OfflineMapper&&) noexcept = default;

bool OfflineMapper::add(const ScanPtr& scan, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    if (progress.cancelled()) return false;
    MapScan entry;
    entry.scan = labelled(scan);
    for (const Label label : entry.scan->labels) ++entry.labelCounts[static_cast<std::size_t>(label)];
    if (progress.cancelled()) return false;
    PointCloud cloud = prepared(*entry.scan, m_state->settings);
    entry.pointsUsed = cloud.size();
    entry.guessInMap = entry.poseInMap = m_state->guessOf(*scan);
    progress.done(PreparedFraction);
    if (!m_state->map.scans.empty()) {
        entry.registered = true;
        if (const Search* const search = m_state->search()) {
            const Progress aligning{[&](double fraction) {
                                        progress.done(PreparedFraction + (1.0 - PreparedFraction) * fraction);
                                    },
                                    progress.stop};
            IcpSettings icp = icpSettings(m_state->settings);
            icp.prior = m_state->priorOf(*scan, entry.guessInMap);
            entry.icp = align(m_state->target(), *search, cloud,
                              m_state->targetInMap.inverse() * entry.guessInMap, icp, aligning);
            if (entry.icp.stop == IcpStop::Cancelled) return false;
            if (entry.icp.stop != IcpStop::Degenerate)
                entry.poseInMap = m_state->targetInMap * entry.icp.pose;
            m_state->learnScale(entry);
        } else {
            entry.icp.stop = IcpStop::Degenerate;
        }
    }
    m_state->setTarget(std::move(cloud), entry.poseInMap);
    entry.seconds = secondsBetween(start, steadyNow());
    m_state->map.scans.push_back(std::move(entry));
    progress.done(1.0);
    return true;
}

MapPtr OfflineMapper::map() const {
    return std::make_shared<const Map>(m_state->map);
}

}  // namespace leitstand
