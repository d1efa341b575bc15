#include "core/registration/icp.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/registration/evaluation.h"
#include "core/registration/pairing.h"
#include "core/registration/pose_history.h"

namespace leitstand {
namespace {

/// Adds its lifetime to a sum.
class Stopwatch {
public:
    explicit Stopwatch(double& seconds) : m_seconds(seconds) {}
    ~Stopwatch() { m_seconds += toSeconds(Clock::now() - m_start); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    using Clock = std::chrono::steady_clock;
    double& m_seconds;
    Clock::time_point m_start = Clock::now();
};

/// Result of a minimiser: a motion to put before the pose, and the cost of the pose per pair.
struct IcpStep {
    std::optional<Pose> motion;
    double cost = 0.0;
};

IcpStep minimise(const Pairing& pairing, const PairSums& sums, const Pose& pose,
                 const MinimizerRow& minimizer, double kernel, const GuessTerm* prior) {
    if (minimizer.equations != nullptr) {
        NormalEquations equations = minimizer.equations(pairing, pose, sums.sourceMean(), kernel);
        const double cost = equations.cost / static_cast<double>(sums.count);
        if (prior != nullptr) prior->add(equations, pose, sums.count, minimizer.pairVariance);
        return {equations.solve(), cost};
    }
    const Fit fit = minimizer.closedForm(sums);
    const bool usable = fit.outcome == FitOutcome::Ok || fit.outcome == FitOutcome::Mirror;
    return {usable ? std::optional(fit.pose) : std::nullopt, sums.squaredDistances / sums.weight};
}

bool hasNormals(const PointCloud& target, const PointCloud& source, const MinimizerRow& minimizer) {
    if (minimizer.sourceNormals && source.normals.empty()) return false;
    return minimizer.equations == nullptr || !target.normals.empty();
}

/// Runs one stage of the schedule from @p result.pose and returns how it ended. Calls @p report after each
/// iteration. @p deviations: IcpSettings::kernel, for this stage.
IcpStop runStage(Pairing& pairing, double maxDistance, double deviations, const IcpSettings& settings,
                 const Progress& progress, IcpResult& result, GuessTerm* prior,
                 const std::function<void()>& report) {
    PoseHistory history;
    bool looked = false;
    std::optional<double> kernel;  // [m]
    const MinimizerRow minimizer = rowOf(settings.minimizer);
    const double minStep = settings.minStep.value_or(minimizer.equations != nullptr ? 1e-4 : 1e-5);
    while (result.iterations < settings.maxIterations) {
        if (progress.cancelled()) return IcpStop::Cancelled;
        PairSums sums;
        {
            const Stopwatch watch(result.times.pairing);
            sums = pairing.update(result.pose, maxDistance, progress.stop);
        }
        if (progress.cancelled()) return IcpStop::Cancelled;
        if (sums.count < 3) return IcpStop::Degenerate;
        const Stopwatch watch(result.times.minimising);
        if (prior != nullptr && !std::exchange(looked, true)) prior->look(pairing, result.pose, maxDistance);
        if (!kernel) kernel = deviations > 0.0 ? deviations * deviationAcross(pairing, result.pose) : 0.0;
        const IcpStep step = minimise(pairing, sums, result.pose, minimizer, *kernel, prior);
        if (!step.motion) return IcpStop::Degenerate;
        history.add(result.pose, step.cost);
        const Pose next = orthonormalised(*step.motion * result.pose);
        const double moved = std::max(distanceBetween(next, result.pose), angleBetween(next, result.pose));
        result.pose = next;
        ++result.iterations;
        report();
        if (moved < minStep) return IcpStop::Converged;
        if (const std::size_t length = history.cycle(minStep); length > 0) {
            result.pose = history.best(length);
            const PoseHistory::Extent size = history.extent(length);
            result.converged =
                size.distance <= PoseHistory::CycleDistance && size.angle <= PoseHistory::CycleAngle;
            return IcpStop::LimitCycle;
        }
    }
    return IcpStop::IterationLimit;
}

}  // namespace

IcpResult align(const PointCloud& target, const Search& search, const PointCloud& source, const Pose& guess,
                const IcpSettings& settings, const Progress& progress) {
    IcpResult result;
    result.pose = guess;
    const MinimizerRow minimizer = rowOf(settings.minimizer);
    if (settings.maxDistances.empty() || !hasNormals(target, source, minimizer)) {
        result.stop = IcpStop::Degenerate;
        return result;
    }
    Pairing pairing(target, search, source, settings.threads, settings.facing);
    std::optional<GuessTerm> prior;
    if (settings.prior && minimizer.equations != nullptr) prior.emplace(*settings.prior, guess);
    const auto stages = static_cast<double>(settings.maxDistances.size());
    double last = settings.maxDistances.front(), paired = last;  // [m]
    for (const double maxDistance : settings.maxDistances) {
        const int before = result.iterations;
        const auto stage = static_cast<double>(result.times.stages.size());
        const auto report = [&] {
            // The number of iterations is unknown: after 10, half of the rest counts as done.
            const double iterations = result.iterations - before;
            progress.done((stage + iterations / (iterations + 10.0)) / stages);
        };
        const IcpResult reached = result;
        result.converged = false;
        const Stopwatch watch(result.times.stages.emplace_back(0.0));
        const bool isLast = result.times.stages.size() == settings.maxDistances.size();
        const bool robust = isLast && minimizer.heedsKernel;
        result.stop = runStage(pairing, maxDistance, robust ? settings.kernel : 0.0, settings, progress,
                               result, prior ? &*prior : nullptr, report);
        if (result.stop == IcpStop::Degenerate && stage > 0.0) {
            // Too few pairs are that near: the result of the earlier stages stays.
            paired = maxDistance;
            result.pose = reached.pose;
            result.stop = reached.stop;
            result.converged = reached.converged;
            break;
        }
        last = paired = maxDistance;
        if (result.stop == IcpStop::Converged) result.converged = true;
        if (result.stop != IcpStop::Converged && result.stop != IcpStop::LimitCycle) break;
    }
    if (prior) result.open = prior->open();
    if (result.stop == IcpStop::Cancelled) return result;
    const Stopwatch watch(result.times.evaluating);
    evaluate(pairing, paired, settings.judgedWithin.value_or(last), result);
    progress.done(1.0);
    return result;
}

}  // namespace leitstand
