#include "core/robot/link/link_status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/known_sentence.h"
#include "core/robot/link/link_reasons.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

std::string wordsOf(StreamRole role) {
    const std::string_view words = streamFacts(role).inLog;
    return words.empty() ? toString(role) : std::string(words);
}

std::string streamOf(const LinkReason& reason) {
    return streamFacts(reason.role).ofCamera && !reason.sensor.empty()
               ? reason.sensor + " " + wordsOf(reason.role)
               : wordsOf(reason.role);
}

constexpr std::pair<LinkReason::Kind, const char*> Sentences[] = {
    {LinkReason::Kind::Silent, "nothing heard for {} s"},
    {LinkReason::Kind::NoAnswer, "no answer to pings for {} s"},
    {LinkReason::Kind::Slow, "round trip {} ms"},
    {LinkReason::Kind::Loss, "{} % of {} lost"},
    {LinkReason::Kind::Stale, "{} s old"},
    {LinkReason::Kind::Late, "{} s late"},
};

/// Reads "left pictures" into @p reason.
bool readStream(std::string_view reported, LinkReason& reason) {
    const auto isWhole = [&](StreamRole role) { return reported == wordsOf(role); };
    const auto roles = allStreamRoles();
    if (const auto role = std::ranges::find_if(roles, isWhole); role != roles.end()) {
        reason.role = *role;
        return true;
    }
    // The longest words first: "left thermal pictures" are not "pictures" of a sensor "left thermal".
    for (const StreamRole role : {StreamRole::Thermal, StreamRole::Picture, StreamRole::CameraInfo}) {
        const std::string words = fmt::format(" {}", wordsOf(role));
        if (reported.size() <= words.size() || !reported.ends_with(words)) continue;
        reason.role = role;
        reason.sensor = std::string(reported.substr(0, reported.size() - words.size()));
        return true;
    }
    return false;
}

}  // namespace

std::optional<LinkReason> linkReasonFrom(std::string_view reported) {
    for (const auto& [kind, words] : Sentences) {
        const KnownSentence found = knownSentence(reported, std::array{words});
        if (found.words == nullptr) continue;
        LinkReason reason;
        reason.kind = kind;
        std::string_view figure = found.values.front(), stream;
        if (found.values.size() == 2) stream = found.values.back();
        const bool before = kind == LinkReason::Kind::Stale || kind == LinkReason::Kind::Late;
        if (before) {
            const auto gap = figure.rfind(' ');
            if (gap == std::string_view::npos) continue;
            stream = figure.substr(0, gap);
            figure.remove_prefix(gap + 1);
        }
        const auto value = figureIn(figure);
        if (!value) continue;
        reason.value = *value;
        if (kind == LinkReason::Kind::Loss) reason.value /= 100.0;
        if (kind == LinkReason::Kind::Slow) reason.value /= 1e3;
        if ((before || kind == LinkReason::Kind::Loss) && !readStream(stream, reason)) continue;
        return reason;
    }
    return std::nullopt;
}

std::string toString(LinkState state) {
    switch (state) {
        case LinkState::NeverSeen:
            return "never seen";
        case LinkState::Connected:
            return "connected";
        case LinkState::Degraded:
            return "degraded";
        case LinkState::Lost:
            return "lost";
    }
    return {};
}

std::string toString(const LinkReason& reason) {
    switch (reason.kind) {
        case LinkReason::Kind::Silent:
            return fmt::format("nothing heard for {:.1f} s", reason.value);
        case LinkReason::Kind::Stale:
            return fmt::format("{} {:.1f} s old", streamOf(reason), reason.value);
        case LinkReason::Kind::Late:
            return fmt::format("{} {:.1f} s late", streamOf(reason), reason.value);
        case LinkReason::Kind::Loss:
            return fmt::format("{:.0f} % of {} lost", 100.0 * reason.value, streamOf(reason));
        case LinkReason::Kind::Slow:
            return fmt::format("round trip {:.0f} ms", 1e3 * reason.value);
        case LinkReason::Kind::NoAnswer:
            return fmt::format("no answer to pings for {:.1f} s", reason.value);
    }
    return {};
}

std::string toString(const std::vector<LinkReason>& reasons) {
    std::string text;
    for (const LinkReason& reason : reasons) text += (text.empty() ? "" : ", ") + toString(reason);
    return text;
}

const StreamStatus* LinkStatus::stream(std::string_view topic) const {
    const auto found = std::find_if(streams.begin(), streams.end(),
                                    [&](const StreamStatus& one) { return one.topic == topic; });
    return found == streams.end() ? nullptr : &*found;
}

std::optional<ClockOffsetSample> clockOffsetOf(const LinkStatus& status, Time stamp) {
    if (!status.clock) return std::nullopt;
    ClockOffsetSample sample;
    sample.stamp = stamp;
    sample.robot = status.robot;
    sample.ahead = status.clock->ahead;
    // any place within the bounds is equally likely
    const double deviation = static_cast<double>(status.clock->uncertainty.count()) / std::sqrt(3.0);
    sample.uncertainty = std::chrono::nanoseconds(std::llround(deviation));
    if (status.roundTrip)
        sample.roundTrip = std::chrono::nanoseconds(std::llround(1e9 * status.roundTrip->last));
    return sample;
}

}  // namespace leitstand
