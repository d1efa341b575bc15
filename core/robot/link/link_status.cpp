#include "core/robot/link/link_status.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/phrases/coded_text.h"
#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
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

/// How the log names a kind and its figure, and in what unit.
struct LoggedKind {
    LinkReason::Kind kind;
    const char* code;
    const char* figure;
    double unit;
    int decimals;
};
constexpr LoggedKind LoggedKinds[] = {
    {LinkReason::Kind::Silent, "silent", "seconds", 1.0, 1},
    {LinkReason::Kind::NoAnswer, "no_answer", "seconds", 1.0, 1},
    {LinkReason::Kind::Slow, "slow", "round_trip_ms", 1e-3, 0},
    {LinkReason::Kind::Loss, "loss", "percent", 1e-2, 0},
    {LinkReason::Kind::Stale, "stale", "seconds", 1.0, 1},
    {LinkReason::Kind::Late, "late", "seconds", 1.0, 1},
};

bool isOfStream(LinkReason::Kind kind) {
    return kind == LinkReason::Kind::Loss || kind == LinkReason::Kind::Stale ||
           kind == LinkReason::Kind::Late;
}

std::optional<LinkReason> codedReason(std::string_view reported) {
    const auto coded = codedText(reported);
    if (!coded) return std::nullopt;
    for (const LoggedKind& one : LoggedKinds) {
        const auto figure = coded->figure(one.figure);
        if (coded->code != one.code || !figure) continue;
        LinkReason reason;
        reason.kind = one.kind;
        reason.value = *figure * one.unit;
        if (!isOfStream(one.kind)) return reason;
        const auto stream = coded->value("stream");
        const auto roles = allStreamRoles();
        const auto role =
            std::ranges::find_if(roles, [&](StreamRole each) { return stream == toString(each); });
        if (role == roles.end()) return std::nullopt;
        reason.role = *role;
        reason.sensor = coded->value("sensor").value_or(std::string());
        return reason;
    }
    return std::nullopt;
}

/// Of logs from before there were codes.
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

std::string logged(const LinkReason& reason) {
    const auto* const kind = std::ranges::find(LoggedKinds, reason.kind, &LoggedKind::kind);
    CodedText coded{kind->code, {}};
    if (isOfStream(reason.kind)) {
        coded.values.emplace_back("stream", toString(reason.role));
        if (streamFacts(reason.role).ofCamera && !reason.sensor.empty())
            coded.values.emplace_back("sensor", reason.sensor);
    }
    coded.values.emplace_back(kind->figure, loggedFigure(reason.value / kind->unit, kind->decimals));
    return toString(coded);
}

std::optional<LinkReason> linkReasonFrom(std::string_view reported) {
    if (auto reason = codedReason(reported)) return reason;
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
