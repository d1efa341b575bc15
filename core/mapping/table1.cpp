#include "core/mapping/table1.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include "core/base/time.h"
#include "core/mapping/scan_preparation.h"
#include "core/registration/icp.h"

namespace leitstand {
namespace {

using Clock = std::chrono::steady_clock;

/// The two clouds of a row.
struct Pair {
    PointCloud target, source;
};

/// One run of a row.
struct Run {
    IcpResult icp;
    double seconds = 0.0;
};

Table1 emptyTable() {
    Table1 table;
    const auto fill = [&](std::size_t row, bool reduced, SearchMethod search, double seconds,
                          int iterations) {
        table[row].reduced = reduced;
        table[row].search = search;
        table[row].paperSeconds = seconds;
        table[row].paperIterations = iterations;
        table[row].paperSpeedUp = seconds > 0.0 ? 35.43 / seconds : 0.0;
    };
    fill(0, false, SearchMethod::BruteForce, 0.0, 42);
    fill(1, false, SearchMethod::KdTree, 35.43, 42);
    fill(2, true, SearchMethod::KdTree, 2.92, 38);
    fill(3, true, SearchMethod::Approximate, 2.22, 39);
    fill(4, true, SearchMethod::Forest, 1.98, 34);
    return table;
}

Pair preparedPair(const Scan& target, const Scan& source, const Table1Settings& settings, bool reduced) {
    RegistrationSettings preparation;
    preparation.reduce = 0.0;
    preparation.filter = reduced ? ScanFilter::Median : ScanFilter::None;
    preparation.minRange = settings.minRange;
    preparation.maxRange = settings.maxRange;
    return {prepared(target, preparation), prepared(source, preparation)};
}

Run runOnce(const Pair& pair, SearchMethod method, const Pose& guess, const Table1Settings& settings,
            int maxIterations, const Progress& progress) {
    IcpSettings icp;
    icp.maxDistances = {settings.maxDistance};
    icp.minStep = settings.minStep;
    icp.maxIterations = maxIterations;
    icp.minimizer = Minimizer::Svd;
    icp.threads = 1;
    const auto start = Clock::now();
    const auto search = makeSearch(pair.target, method, settings.epsilon);
    Run run;
    run.icp = align(pair.target, *search, pair.source, guess, icp, {{}, progress.stop});
    // The evaluation of the fit comes on top of the alignment, and is no part of the paper's method.
    run.seconds = toSeconds(Clock::now() - start) - run.icp.times.evaluating;
    return run;
}

void compare(Table1Row& row, const IcpResult& icp, const Pose& expected) {
    row.iterations = icp.iterations;
    row.distance = distanceBetween(icp.pose, expected);
    row.angle = angleBetween(icp.pose, expected);
    row.counts =
        icp.converged && row.distance <= Table1Row::CountDistance && row.angle <= Table1Row::CountAngle;
}

/// Extrapolates brute force from some iterations, compared with as many of the kd-tree. Both pair the same
/// points, so brute force would take as many iterations as the kd-tree.
void extrapolateBruteForce(Table1& table, const Pair& all, const Pose& guess, const Table1Settings& settings,
                           const Progress& progress) {
    Table1Row& row = table[0];
    const int iterations = std::min(settings.bruteForceIterations, table[1].iterations);
    const Run brute = runOnce(all, SearchMethod::BruteForce, guess, settings, iterations, progress);
    const Run tree = runOnce(all, SearchMethod::KdTree, guess, settings, iterations, progress);
    compare(row, brute.icp, tree.icp.pose);
    row.counts = row.distance <= Table1Row::CountDistance && row.angle <= Table1Row::CountAngle;
    row.extrapolated = iterations < table[1].iterations;
    row.seconds = brute.seconds * table[1].iterations / std::max(1, brute.icp.iterations);
    row.iterations = table[1].iterations;
}

}  // namespace

Result<Table1> measureTable1(const Scan& target, const Scan& source, const Table1Settings& settings,
                             const Progress& progress) {
    Table1 table = emptyTable();
    const Pair all = preparedPair(target, source, settings, false);
    const Pair reduced = preparedPair(target, source, settings, true);
    if (reduced.target.points.empty() || reduced.source.points.empty()) {
        return Error{(reduced.target.points.empty() ? target.name : source.name) +
                     ": expected points in range, found none"};
    }
    const Pose guess = target.sensorInOdom.inverse() * source.sensorInOdom;
    std::array<std::vector<double>, 5> seconds;
    std::array<IcpResult, 5> results;
    // The rows take turns, so that a machine that speeds up or slows down does so for all of them.
    for (int repetition = 0; repetition < settings.repetitions; ++repetition) {
        for (std::size_t row = 1; row < table.size(); ++row) {
            const Run run = runOnce(table[row].reduced ? reduced : all, table[row].search, guess, settings,
                                    settings.maxIterations, progress);
            if (progress.cancelled()) return Error{"cancelled"};
            seconds[row].push_back(run.seconds);
            results[row] = run.icp;
            progress.done((4.0 * repetition + static_cast<double>(row)) / (4.0 * settings.repetitions + 1.0));
        }
    }
    for (std::size_t row = 1; row < table.size(); ++row) {
        std::sort(seconds[row].begin(), seconds[row].end());
        table[row].seconds = seconds[row][seconds[row].size() / 2];
        compare(table[row], results[row], results[1].pose);
    }
    extrapolateBruteForce(table, all, guess, settings, progress);
    if (progress.cancelled()) return Error{"cancelled"};
    for (Table1Row& row : table) {
        row.speedUp = table[1].seconds / row.seconds;
        row.targetPoints = (row.reduced ? reduced : all).target.size();
        row.sourcePoints = (row.reduced ? reduced : all).source.size();
    }
    progress.done(1.0);
    return table;
}

}  // namespace leitstand
