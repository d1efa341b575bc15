#pragma once

#include <chrono>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/mission/finds/candidate_book.h"
#include "core/mission/finds/dismissal.h"

namespace leitstand::test {

/// A cue that a TestedBook is given.
struct GivenCue {
    std::string kind = "heat";
    Eigen::Vector3d place = {2, 1, 0.2};
    double confidence = 0.9;
    std::string text = {};
    double deviation = 0.08;
};

/// A book of candidates on a clock of its own, and what it told of each last.
struct TestedBook {
    CandidateBook book{"us"};
    std::map<std::uint32_t, CandidateSample> reported;
    int updates = 0;
    double time = 0.0;

    [[nodiscard]] static Time at(double seconds) {
        return Time(std::chrono::milliseconds(1'000'000 + static_cast<int>(1000.0 * seconds)));
    }
    /// @p times: every half second.
    void give(const GivenCue& given, int times = 8) {
        for (int i = 0; i < times; ++i) {
            PlacedCue cue;
            cue.cue.kind = given.kind;
            cue.cue.robot = "kurt3d";
            cue.cue.confidence = given.confidence;
            cue.cue.text = given.text;
            cue.cue.stamp = at(time);
            if (given.kind == "code") cue.what = FindSample::Kind::Code;
            cue.inMap = given.place;
            cue.covariance = given.deviation * given.deviation * Eigen::Matrix3d::Identity();
            book.add(cue);
            pass(0.5);
        }
    }
    void pass(double seconds) {
        time += seconds;
        for (const CandidateSample& one : book.due(at(time))) {
            reported[one.id] = one;
            ++updates;
        }
    }
    void dismiss(std::uint32_t id) {
        reported.at(id) = judged(reported.at(id), true, "us", at(time + 0.1));
        book.take(reported.at(id));
    }
    [[nodiscard]] std::vector<CandidateSample> victims() const {
        std::vector<CandidateSample> list;
        for (const auto& [id, one] : reported) {
            if (!one.dismissed && one.kind == FindSample::Kind::Victim) list.push_back(one);
        }
        return list;
    }
};

}  // namespace leitstand::test
