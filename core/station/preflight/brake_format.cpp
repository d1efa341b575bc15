#include "core/station/preflight/brake_format.h"

#include <array>
#include <cmath>

#include "core/base/known_sentence.h"
#include "core/base/words.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {
namespace {

using Cause = BrakeResult::Cause;
using Verdict = BrakeResult::Verdict;

constexpr auto Untested = translatable("leitstand::BrakeSays", "brake not tested");
constexpr auto Passed =
    translatable("leitstand::BrakeSays", "brake test passed: it stood after {} ms and {} cm");
constexpr auto PassedAfter =
    translatable("leitstand::BrakeSays",
                 "brake test passed: without commands it braked after {} ms and stood after {} ms and {} cm");
constexpr auto FailedAfter = translatable(
    "leitstand::BrakeSays",
    "brake test FAILED: without commands it braked after {} ms and stood only after {} ms and {} cm");
constexpr auto Failed = translatable(
    "leitstand::BrakeSays", "brake test FAILED: without commands it still moved after {} ms and {} cm");
constexpr auto Inconclusive = translatable("leitstand::BrakeSays", "brake test without result: {}");
constexpr auto NoRoom = translatable("leitstand::BrakeSays", "only {} cm are free ahead, {} cm are needed");
constexpr std::array<const char*, 6> Verdicts = {Untested,    Passed, PassedAfter,
                                                 FailedAfter, Failed, Inconclusive};

struct CauseWords {
    Cause cause;
    const char* words;
};
/// The preflight page uses the same words.
constexpr std::array<CauseWords, 11> Causes = {{
    {Cause::KeyLetGo, translatable("leitstand::PreflightList", "the key was let go")},
    {Cause::NotDriven, translatable("leitstand::PreflightList", "the robot was not to be driven any more")},
    {Cause::RoomUnknown,
     translatable("leitstand::PreflightList", "nothing tells whether there is room ahead")},
    {Cause::NotAllowed, translatable("leitstand::PreflightList", "the station may not drive the robot")},
    {Cause::Deaf, translatable("leitstand::PreflightList", "the robot hears no drive commands")},
    {Cause::NoOdometry, translatable("leitstand::PreflightList", "no odometry comes")},
    {Cause::SticksHeld, translatable("leitstand::PreflightList", "the sticks were not let go")},
    {Cause::NotStanding, translatable("leitstand::PreflightList", "the robot did not stand")},
    {Cause::TooSlow, translatable("leitstand::PreflightList", "the robot did not come to its speed")},
    {Cause::OdometryEnded, translatable("leitstand::PreflightList", "no odometry came after the cut")},
    {Cause::None, translatable("leitstand::PreflightList", "nothing tells why")},
}};

std::string whole(double value) {
    return loggedFigure(std::isfinite(value) ? value : 0.0);
}

std::string standing(const char* words, const BrakeResult& result) {
    return leitstand::fill(words, whole(1e3 * result.brakesAfter), whole(1e3 * result.seconds),
                           whole(100.0 * result.metres));
}

std::string causeOf(const BrakeResult& result) {
    if (result.cause == Cause::NoRoom)
        return leitstand::fill(NoRoom, whole(100.0 * result.free), whole(100.0 * result.needed));
    for (const CauseWords& one : Causes) {
        if (one.cause == result.cause) return one.words;
    }
    return {};
}

std::string causeWorded(const std::string& reported) {
    const KnownSentence room = knownSentence(reported, std::array{NoRoom});
    if (room.words != nullptr) return withValues(translate("leitstand::BrakeSays", room.words), room.values);
    for (const CauseWords& one : Causes) {
        if (reported == one.words) return translate("leitstand::PreflightList", one.words);
    }
    return reported;
}

}  // namespace

std::string toString(const BrakeResult& result) {
    switch (result.verdict) {
        case Verdict::Untested:
            return Untested;
        case Verdict::Passed:
            if (result.brakesAfter > 0.0) return standing(PassedAfter, result);
            return leitstand::fill(Passed, whole(1e3 * result.seconds), whole(100.0 * result.metres));
        case Verdict::Failed:
            if (result.watchdog == BrakeResult::Watchdog::Stops) return standing(FailedAfter, result);
            return leitstand::fill(Failed, whole(1e3 * result.seconds), whole(100.0 * result.metres));
        case Verdict::Inconclusive:
            return leitstand::fill(Inconclusive, causeOf(result));
    }
    return {};
}

std::string brakeWorded(const std::string& reported) {
    KnownSentence sentence = knownSentence(reported, Verdicts);
    if (sentence.words == nullptr) return reported;
    if (sentence.words == Inconclusive) sentence.values.front() = causeWorded(sentence.values.front());
    return withValues(translate("leitstand::BrakeSays", sentence.words), sentence.values);
}

}  // namespace leitstand
