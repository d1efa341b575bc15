#include "app/services/comparison/map_comparing.h"

#include <algorithm>
#include <exception>
#include <map>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "app/services/comparison/recorded_truth.h"
#include "app/services/job_queue.h"
#include "app/services/recorded/review_log.h"
#include "core/base/words.h"
#include "core/event/find_sample.h"
#include "core/event/scan_pose.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/settings/comparison_file.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

std::vector<ComparedScan> scansOf(const ReviewIndex& index, int& rejected) {
    std::vector<ComparedScan> scans;
    for (const auto& [id, kept] : *index.finished->keyScans) {
        const auto reported = index.keyScans.find(id);
        if (reported == index.keyScans.end() || !reported->second.scan) continue;
        if (kept.pose.trust == ScanTrust::SetAside) {
            ++rejected;
            continue;
        }
        ComparedScan one;
        one.id = id;
        one.scan = reported->second.scan;
        one.robot = kept.entry.robot.empty() ? one.scan->robot : kept.entry.robot;
        one.end = one.scan->end == Time{} ? kept.entry.stamp : one.scan->end;
        one.sensorInBase = kept.entry.sensorInBase;
        one.recorded = one.again = kept.pose.scanInMap;
        one.uncertainRecorded = kept.pose.trust == ScanTrust::Uncertain;
        scans.push_back(std::move(one));
    }
    return scans;
}

std::optional<TrajectoryError> errorOf(const MapComparison& whole, const RecordedTruth& truth,
                                       Pose ComparedScan::*pose) {
    std::map<std::string, std::vector<StampedPose>> ways;
    for (const ComparedScan& one : whole.scans)
        ways[one.robot].push_back({one.end, one.*pose * one.sensorInBase.inverse()});
    std::vector<PosePair> pairs;
    for (const auto& [robot, way] : ways) {
        const auto known = truth.robots.find(robot);
        if (known == truth.robots.end()) continue;
        const auto more = pairsOf(way, known->second);
        pairs.insert(pairs.end(), more.begin(), more.end());
    }
    return trajectoryError(pairs);
}

std::optional<FindsError> findsOf(const MissionState& state, const MapComparison& whole,
                                  const RecordedTruth& truth, const Pose& mapInWorld,
                                  Pose ComparedScan::*pose) {
    if (truth.victims.empty()) return std::nullopt;
    std::vector<Eigen::Vector3d> places;
    for (const auto& [key, kept] : *state.finds) {
        const FindSample& find = kept.victim;
        if (find.kind != FindSample::Kind::Victim || find.status == FindSample::Status::Discarded) continue;
        const auto scan = std::find_if(whole.scans.begin(), whole.scans.end(),
                                       [&](const ComparedScan& one) { return one.id == find.scan; });
        const bool hangs = find.scan != 0 && scan != whole.scans.end();
        places.push_back(mapInWorld * (hangs ? Eigen::Vector3d(*scan.*pose * find.positionInScan)
                                             : positionInMap(state, find)));
    }
    return compareFinds(places, truth.victims);
}

}  // namespace

Result<MapComparisonPtr> compareMaps(const std::filesystem::path& folder, const ReviewIndex& index,
                                     const RegistrationSettings& settings, const Progress& progress) {
    int rejected = 0;
    auto scans = scansOf(index, rejected);
    if (scans.empty())
        return Error{
            fill(translate("leitstand::Station", "{}: there are no key scans that could be registered again"),
                 folder.string())};
    auto made = registeredAgain(std::move(scans), settings, progress);
    if (!made) return MapComparisonPtr();
    made->rejected = rejected;
    auto bag = BagReader::open(folder);
    if (!bag) return bag.error();
    const RecordedTruth truth = readTruth(**bag, {{}, progress.stop});
    for (const bool again : {false, true}) {
        MapFigures& figures = again ? made->again : made->recorded;
        const auto pose = again ? &ComparedScan::again : &ComparedScan::recorded;
        figures.truth = errorOf(*made, truth, pose);
        if (figures.truth)
            figures.finds = findsOf(*index.finished, *made, truth, figures.truth->mapInWorld, pose);
    }
    if (progress.cancelled()) return MapComparisonPtr();
    return std::make_shared<const MapComparison>(std::move(*made));
}

std::filesystem::path comparisonFileOf(const std::filesystem::path& folder) {
    return folder / "comparison.yaml";
}

Result<MapComparisonPtr> keptComparison(const std::filesystem::path& folder, const ReviewIndex& index) {
    const std::filesystem::path file = comparisonFileOf(folder);
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return MapComparisonPtr();
    auto kept = readComparison(file);
    if (!kept) return kept.error();
    MapComparison whole = std::move(kept).value();
    int rejected = 0;
    std::map<std::uint64_t, ComparedScan> known;
    for (ComparedScan& one : scansOf(index, rejected)) known.emplace(one.id, std::move(one));
    for (ComparedScan& one : whole.scans) {
        const auto found = known.find(one.id);
        if (found == known.end() || known.size() != whole.scans.size())
            return Error{leitstand::fill(
                translate("leitstand::Error",
                          "{}: is of other key scans than the mission has now; register again"),
                file.string())};
        one.scan = found->second.scan;
        one.robot = found->second.robot;
        one.end = found->second.end;
        one.sensorInBase = found->second.sensorInBase;
    }
    sumUp(whole);  // paths are per robot
    return std::make_shared<const MapComparison>(std::move(whole));
}

struct MapComparing::State {
    Listener listener;
    JobQueue queue;
    std::jthread thread;  ///< last: joined first

    static Result<ComparedMapsPtr> shown(const Result<MapComparisonPtr>& made, bool remembered) {
        if (!made) return made.error();
        if (!*made) return ComparedMapsPtr();
        ComparedMaps maps{*made, mapOf(**made, ComparedMap::Again), mapOf(**made, ComparedMap::Both),
                          remembered};
        return std::make_shared<const ComparedMaps>(std::move(maps));
    }
    void notify(const std::string& text) const {
        if (listener.onMessage) listener.onMessage(text);
    }

    void compare(const std::filesystem::path& folder, const ReviewIndex& index,
                 const RegistrationSettings& settings, const std::stop_token& cancelled) {
        Result<ComparedMapsPtr> result = ComparedMapsPtr();
        try {
            const auto made = compareMaps(folder, index, settings, {listener.onProgress, cancelled});
            if (made && *made && !isOfOthers(folder)) {
                if (const auto kept = saveComparison(**made, comparisonFileOf(folder)); !kept)
                    notify(kept.error().text);
            }
            result = shown(made, false);
        } catch (const std::exception& broken) {
            result = Error{broken.what()};
        }
        if (listener.onFinished) listener.onFinished(result);
    }

    void recall(const std::filesystem::path& folder, const ReviewIndex& index) {
        try {
            const auto result = shown(keptComparison(folder, index), true);
            if (!result) return notify(result.error().text);
            if (*result && listener.onFinished) listener.onFinished(result);
        } catch (const std::exception& broken) {
            notify(broken.what());
        }
    }
};

MapComparing::MapComparing(Listener listener) : m_state(std::make_unique<State>()) {
    m_state->listener = std::move(listener);
    m_state->thread =
        std::jthread([state = m_state.get()](const std::stop_token& stop) { state->queue.work(stop); });
}

MapComparing::~MapComparing() {
    m_state->thread.request_stop();
    m_state->queue.cancel();
}

void MapComparing::begin(std::filesystem::path folder, ReviewIndexPtr index, RegistrationSettings settings) {
    m_state->queue.submit([state = m_state.get(), folder = std::move(folder), index = std::move(index),
                           settings = std::move(settings)](const std::stop_token& cancelled) {
        state->compare(folder, *index, settings, cancelled);
    });
}

void MapComparing::recall(std::filesystem::path folder, ReviewIndexPtr index) {
    m_state->queue.submit([state = m_state.get(), folder = std::move(folder), index = std::move(index)](
                              const std::stop_token&) { state->recall(folder, *index); });
}

void MapComparing::cancel() {
    m_state->queue.cancel();
}

}  // namespace leitstand
