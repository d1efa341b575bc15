#include "core/station/preflight/brake_format.h"

#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "core/base/phrases/coded_text.h"
#include "core/base/words.h"
#include "core/station/preflight/brake_test.h"

namespace leitstand {
namespace {

using Cause = BrakeResult::Cause;
using Verdict = BrakeResult::Verdict;

constexpr const char* Context = "leitstand::BrakeSays";
constexpr LogPhrase Untested = {"brake_untested", translatable("leitstand::BrakeSays", "brake not tested")};
constexpr LogPhrase Passed = {
    "brake_passed",
    translatable("leitstand::BrakeSays", "brake test passed: it stood after {} ms and {} cm"),
    {"stood_ms", "way_cm"}};
constexpr LogPhrase PassedAfter = {
    "brake_passed",
    translatable("leitstand::BrakeSays",
                 "brake test passed: without commands it braked after {} ms and stood after {} ms and {} cm"),
    {"braked_ms", "stood_ms", "way_cm"}};
constexpr LogPhrase FailedAfter = {
    "brake_failed",
    translatable(
        "leitstand::BrakeSays",
        "brake test FAILED: without commands it braked after {} ms and stood only after {} ms and {} cm"),
    {"braked_ms", "stood_ms", "way_cm"}};
constexpr LogPhrase Failed = {
    "brake_failed",
    translatable("leitstand::BrakeSays",
                 "brake test FAILED: without commands it still moved after {} ms and {} cm"),
    {"moved_ms", "way_cm"}};
constexpr LogPhrase Inconclusive = {
    "brake_inconclusive", translatable("leitstand::BrakeSays", "brake test without result: {}"), {"why"}};
constexpr LogPhrase NoRoom = {
    "no_room",
    translatable("leitstand::BrakeSays", "only {} cm are free ahead, {} cm are needed"),
    {"free_cm", "needed_cm"}};
/// Of one code, the one with the most values first.
constexpr std::array Verdicts = {Untested, PassedAfter, Passed, FailedAfter, Failed, Inconclusive};

/// The preflight page uses the same words.
constexpr std::array<std::pair<Cause, LogPhrase>, 11> Causes = {{
    {Cause::KeyLetGo, {"key_released", translatable("leitstand::PreflightList", "the key was let go")}},
    {Cause::NotDriven,
     {"not_driven", translatable("leitstand::PreflightList", "the robot was not to be driven any more")}},
    {Cause::RoomUnknown,
     {"room_unknown", translatable("leitstand::PreflightList", "nothing tells whether there is room ahead")}},
    {Cause::NotAllowed,
     {"not_allowed", translatable("leitstand::PreflightList", "the station may not drive the robot")}},
    {Cause::Deaf,
     {"no_commands_received", translatable("leitstand::PreflightList", "the robot hears no drive commands")}},
    {Cause::NoOdometry, {"no_odometry", translatable("leitstand::PreflightList", "no odometry comes")}},
    {Cause::SticksHeld,
     {"sticks_held", translatable("leitstand::PreflightList", "the sticks were not let go")}},
    {Cause::NotStanding,
     {"not_standing", translatable("leitstand::PreflightList", "the robot did not stand")}},
    {Cause::TooSlow,
     {"too_slow", translatable("leitstand::PreflightList", "the robot did not come to its speed")}},
    {Cause::OdometryEnded,
     {"odometry_ended", translatable("leitstand::PreflightList", "no odometry came after the cut")}},
    {Cause::None, {"unknown", translatable("leitstand::PreflightList", "nothing tells why")}},
}};

std::string whole(double value) {
    return loggedFigure(std::isfinite(value) ? value : 0.0);
}

std::string standing(const LogPhrase& phrase, const BrakeResult& result) {
    return logged(phrase, whole(1e3 * result.brakesAfter), whole(1e3 * result.seconds),
                  whole(100.0 * result.metres));
}

std::string causeOf(const BrakeResult& result) {
    if (result.cause == Cause::NoRoom)
        return logged(NoRoom, whole(100.0 * result.free), whole(100.0 * result.needed));
    for (const auto& [cause, phrase] : Causes) {
        if (cause == result.cause) return logged(phrase);
    }
    return {};
}

std::string causeWorded(const std::string& reported) {
    const ReadPhrase room = readPhrase(reported, std::array{NoRoom});
    if (room.phrase) return wordsOf(Context, room);
    for (const auto& [cause, phrase] : Causes) {
        const ReadPhrase known = readPhrase(reported, std::array{phrase});
        if (known.phrase) return wordsOf("leitstand::PreflightList", known);
    }
    return reported;
}

}  // namespace

std::string toString(const BrakeResult& result) {
    switch (result.verdict) {
        case Verdict::Untested:
            return logged(Untested);
        case Verdict::Passed:
            if (result.brakesAfter > 0.0) return standing(PassedAfter, result);
            return logged(Passed, whole(1e3 * result.seconds), whole(100.0 * result.metres));
        case Verdict::Failed:
            if (result.watchdog == BrakeResult::Watchdog::Stops) return standing(FailedAfter, result);
            return logged(Failed, whole(1e3 * result.seconds), whole(100.0 * result.metres));
        case Verdict::Inconclusive:
            return logged(Inconclusive, causeOf(result));
    }
    return {};
}

std::string brakeWorded(const std::string& reported) {
    ReadPhrase read = readPhrase(reported, Verdicts);
    if (!read.phrase) return reported;
    if (read.phrase->code == std::string_view(Inconclusive.code))
        read.values.front() = causeWorded(read.values.front());
    return wordsOf(Context, read);
}

}  // namespace leitstand
