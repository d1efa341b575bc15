#include "core/mapping/comparison/map_changes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/mapping/live/loops/places/free_spaces.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {
namespace {

using Cell = std::array<int, 3>;

constexpr float Farthest =
    1e3F;  ///< no scanner sees so far [m]; a log's farther points would overflow the cells

Cell cellAt(const Eigen::Vector3f& place, double edge) {
    const auto along = [edge](float coordinate) {
        return static_cast<int>(std::floor(static_cast<double>(coordinate) / edge));
    };
    return {along(place.x()), along(place.y()), along(place.z())};
}

/// A cell of changed points.
struct Changed {
    Eigen::Vector3f place;            ///< in the map [m]
    std::map<std::uint64_t, int> by;  ///< scans that have points there
};

/// Compares key scans by the space that they looked through, which is computed once for each.
class Comparison {
public:
    Comparison(std::span<const ReportScan> scans, const ChangeSettings& settings)
        : m_settings(settings), m_free(settings.looking) {
        for (const ReportScan& scan : scans) m_scans.emplace(scan.id, &scan);
    }

    /// Returns the cells in which scans @p of have points where scans of @p others looked through.
    std::map<Cell, Changed> changed(const std::set<std::uint64_t>& of, const std::set<std::uint64_t>& others,
                                    const Progress& progress) {
        std::map<Cell, Changed> cells;
        for (const std::uint64_t id : of) {
            if (progress.cancelled()) return {};
            const ReportScan& scan = *m_scans.at(id);
            const std::vector<const ReportScan*> judges = nearest(scan, others), own = nearest(scan, of);
            if (!judges.empty()) {
                add(cells, scan, judges, own);
                ++m_compared;
            }
            progress.done(static_cast<double>(++m_done));
        }
        return cells;
    }

    /// Number of scans with scans of the other visit nearby.
    [[nodiscard]] std::size_t compared() const { return m_compared; }

private:
    struct Votes {
        int through = 0, seen = 0;
    };

    std::vector<const ReportScan*> nearest(const ReportScan& to, const std::set<std::uint64_t>& of) const {
        std::vector<std::pair<double, const ReportScan*>> near;
        for (const std::uint64_t id : of) {
            const ReportScan* const scan = m_scans.at(id);
            const double distance = mapDistance(scan->scanInMap, to.scanInMap);
            if (id != to.id && distance <= m_settings.reach) near.emplace_back(distance, scan);
        }
        std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
            return std::pair(a.first, a.second->id) < std::pair(b.first, b.second->id);
        });
        near.resize(std::min(near.size(), m_settings.scans));
        std::vector<const ReportScan*> scans;
        for (const auto& [distance, scan] : near) scans.push_back(scan);
        return scans;
    }

    Votes votesOn(const Eigen::Vector3d& place, const std::vector<const ReportScan*>& by) {
        Votes votes;
        for (const ReportScan* const scan : by) {
            const Eigen::Vector3d inScan = scan->scanInMap.inverse() * place;
            const SeenThere there = m_free.of(scan->id, *scan->scan).at(inScan.cast<float>());
            if (there == SeenThere::LookedThrough) ++votes.through;
            if (there == SeenThere::Surface) ++votes.seen;
        }
        return votes;
    }

    void add(std::map<Cell, Changed>& cells, const ReportScan& scan,
             const std::vector<const ReportScan*>& judges, const std::vector<const ReportScan*>& own) {
        std::set<Cell> asked;
        for (const Eigen::Vector3f& point : scan.scan->points) {
            if (!point.allFinite() || point.cwiseAbs().maxCoeff() > Farthest) continue;
            const Eigen::Vector3d place = scan.scanInMap * point.cast<double>();
            const Cell cell = cellAt(place.cast<float>(), m_settings.edge);
            if (!asked.insert(cell).second) continue;
            const Votes others = votesOn(place, judges);
            if (others.through < m_settings.looksThrough || others.through < m_settings.oftener * others.seen)
                continue;
            // Something that other scans of its own visit looked through has passed by.
            const Votes mine = votesOn(place, own);
            if (mine.through > mine.seen) continue;
            ++cells.try_emplace(cell, Changed{place.cast<float>(), {}}).first->second.by[scan.id];
        }
    }

    const ChangeSettings& m_settings;
    std::map<std::uint64_t, const ReportScan*> m_scans;
    FreeSpaces m_free;
    std::size_t m_done = 0, m_compared = 0;
};

/// Returns the deviation of @p places along the second of their principal axes [m].
double secondDeviation(const std::vector<Eigen::Vector3f>& places) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3f& place : places) mean += place.cast<double>();
    mean /= static_cast<double>(places.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3f& place : places) {
        const Eigen::Vector3d off = place.cast<double>() - mean;
        covariance += off * off.transpose();
    }
    covariance /= static_cast<double>(places.size());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, axes.eigenvalues()[1]));
}

/// Returns the connected groups of @p cells that are large enough to be a thing.
std::vector<ChangedThing> thingsOf(std::map<Cell, Changed> cells, bool isNew,
                                   const ChangeSettings& settings) {
    const int reach = static_cast<int>(std::ceil(settings.linked / settings.edge));
    const auto linked = static_cast<float>(settings.linked);
    std::vector<ChangedThing> things;
    while (!cells.empty()) {
        std::vector<std::pair<Cell, Changed>> thing;
        thing.push_back(std::move(*cells.begin()));
        cells.erase(cells.begin());
        for (std::size_t next = 0; next < thing.size(); ++next) {
            const Cell at = thing[next].first;
            const Eigen::Vector3f place = thing[next].second.place;
            for (int x = -reach; x <= reach; ++x) {
                for (int y = -reach; y <= reach; ++y) {
                    for (int z = -reach; z <= reach; ++z) {
                        const auto near = cells.find({at[0] + x, at[1] + y, at[2] + z});
                        if (near == cells.end() || (near->second.place - place).norm() > linked) continue;
                        thing.push_back(std::move(*near));
                        cells.erase(near);
                    }
                }
            }
        }
        ChangedThing found;
        found.isNew = isNew;
        std::map<std::uint64_t, int> by;
        for (const auto& [cell, one] : thing) {
            found.box.extend(one.place.cast<double>());
            found.cells.push_back(one.place);
            for (const auto& [scan, points] : one.by) by[scan] += points;
        }
        if (found.cells.size() < settings.least || secondDeviation(found.cells) < settings.thinnest) continue;
        found.scan = std::max_element(by.begin(), by.end(), [](const auto& a, const auto& b) {
                         return a.second < b.second;
                     })->first;
        things.push_back(std::move(found));
    }
    return things;
}

}  // namespace

std::string carriedFrom(const std::string& robot) {
    const std::size_t at = robot.find('@');
    return at == std::string::npos ? std::string() : robot.substr(at + 1);
}

Visits visitsOf(std::span<const ReportScan> scans) {
    std::map<std::string, std::uint64_t> newest;  // newest scan of each mission
    for (const ReportScan& scan : scans) {
        std::uint64_t& known = newest[carriedFrom(scan.scan->robot)];
        known = std::max(known, scan.id);
    }
    Visits visits;
    if (newest.size() < 2) return visits;
    visits.name = std::max_element(newest.begin(), newest.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                  })->first;
    // The mission's own scans are newer than those of the maps that it continues.
    if (newest.contains({})) visits.name.clear();
    for (const auto& [name, id] : newest) {
        if (name != visits.name) visits.earlier.insert(name);
    }
    for (const ReportScan& scan : scans)
        (carriedFrom(scan.scan->robot) == visits.name ? visits.after : visits.before).insert(scan.id);
    return visits;
}

MapChanges changesOf(std::span<const ReportScan> scans, const ChangeSettings& settings,
                     const Progress& progress) {
    MapChanges changes;
    changes.visits = visitsOf(scans);
    const Visits& visits = changes.visits;
    if (visits.after.empty()) return changes;
    Comparison comparison(scans, settings);
    const auto all = static_cast<double>(visits.before.size() + visits.after.size());
    const Progress inAll{[&](double done) { progress.done(done / all); }, progress.stop};
    std::vector<ChangedThing> things =
        thingsOf(comparison.changed(visits.after, visits.before, inAll), true, settings);
    std::vector<ChangedThing> gone =
        thingsOf(comparison.changed(visits.before, visits.after, inAll), false, settings);
    if (progress.cancelled()) return changes;
    changes.compared = comparison.compared();
    std::move(gone.begin(), gone.end(), std::back_inserter(things));
    std::stable_sort(things.begin(), things.end(), [](const ChangedThing& a, const ChangedThing& b) {
        return a.cells.size() > b.cells.size();
    });
    changes.things = std::move(things);
    return changes;
}

}  // namespace leitstand
