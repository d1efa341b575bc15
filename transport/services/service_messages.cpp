#include "transport/services/service_messages.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/base/printable.h"
#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"
#include "transport/cdr/encapsulation.h"
#include "transport/services/goal_info.h"

namespace leitstand {
namespace {

constexpr std::string_view RequestPrefix = "rq/", AnswerPrefix = "rr/", RequestSuffix = "Request",
                           AnswerSuffix = "Reply", RequestType = "_Request", AnswerType = "_Response";
constexpr std::size_t MostText = 200, HeaderSize = 16;
constexpr std::int8_t Cancelled = 0;  // ERROR_NONE; there may have been no goal

Payload payloadOf(CdrWriter&& out) {
    return std::make_shared<const std::vector<std::byte>>(std::move(out).finish());
}

/// Whether a service of @p kind is asked to cancel goals.
bool isOfGoals(ServiceKind kind) {
    return kind == ServiceKind::CancelGoal || kind == ServiceKind::Navigate;
}

std::string cut(const std::string& text) {
    return printable(std::string_view(text).substr(0, MostText));
}

}  // namespace

ServiceTopics topicsOf(const std::string& name, const std::string& type) {
    const std::string bare = name.starts_with('/') ? name.substr(1) : name;
    return {std::string(RequestPrefix).append(bare).append(RequestSuffix),
            std::string(AnswerPrefix).append(bare).append(AnswerSuffix), type + std::string(RequestType),
            type + std::string(AnswerType)};
}

std::string serviceOf(const std::string& ddsTopic) {
    if (!ddsTopic.starts_with(RequestPrefix) || !ddsTopic.ends_with(RequestSuffix) ||
        ddsTopic.size() <= RequestPrefix.size() + RequestSuffix.size())
        return {};
    const std::string_view name = ddsTopic;
    return fmt::format(
        "/{}", name.substr(RequestPrefix.size(), name.size() - RequestPrefix.size() - RequestSuffix.size()));
}

std::string serviceTypeOf(const std::string& rosType) {
    if (!rosType.ends_with(RequestType)) return {};
    return rosType.substr(0, rosType.size() - RequestType.size());
}

Payload encodeRequest(ServiceKind kind, const ServiceRequest& request) {
    CdrWriter out;
    switch (kind) {
        case ServiceKind::Switch:
            out.write(request.value);
            break;
        case ServiceKind::Trigger:
            out.write(std::uint8_t{0});  // ROS 2 has no empty structures
            break;
        case ServiceKind::CancelGoal:
        case ServiceKind::Navigate:  // of an action, only this is asked so
            out.write(GoalInfo{});   // no goal and no time: all goals
            break;
    }
    return payloadOf(std::move(out));
}

Payload encodeAnswer(ServiceKind kind, const ServiceAnswer& answer) {
    CdrWriter out;
    if (isOfGoals(kind)) {
        out.write(answer.accepted ? Cancelled : std::int8_t{1});
        out.write(std::vector<GoalInfo>{});
    } else {
        out.write(answer.accepted);
        out.write(answer.message);
    }
    return payloadOf(std::move(out));
}

Result<ServiceRequest> decodeRequest(ServiceKind kind, std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    ServiceRequest request;
    if (kind == ServiceKind::Switch) {
        in.read("data", request.value);
    } else if (isOfGoals(kind)) {
        GoalInfo goal;
        in.read("goal_info", goal);
    } else {
        std::uint8_t nothing = 0;
        in.read("structure_needs_at_least_one_member", nothing);
    }
    if (auto done = in.finish(); !done) return done.error();
    return request;
}

Result<ServiceAnswer> decodeAnswer(ServiceKind kind, std::span<const std::byte> bytes) {
    CdrReader in(bytes);
    ServiceAnswer answer;
    if (isOfGoals(kind)) {
        std::int8_t code = 0;
        std::vector<GoalInfo> goals;
        in.read("return_code", code);
        in.read("goals_canceling", goals);
        answer.accepted = code == Cancelled;
    } else {
        in.read("success", answer.accepted);
        in.read("message", answer.message);
        answer.message = cut(answer.message);
    }
    if (auto done = in.finish(); !done) return done.error();
    return answer;
}

Payload withHeader(const CallHeader& header, const Payload& body) {
    // The header is as long as two of the largest fields, so what follows keeps its padding.
    const bool little = (std::to_integer<unsigned>((*body)[1]) & 1U) != 0;
    CdrWriter out(little ? std::endian::little : std::endian::big);
    out.reserve(body->size() + HeaderSize);
    out.write(header.client);
    out.write(header.number);
    std::vector<std::byte> bytes = std::move(out).finish();
    bytes.insert(bytes.end(), body->begin() + EncapsulationSize, body->end());
    return std::make_shared<const std::vector<std::byte>>(std::move(bytes));
}

std::optional<HeadedBody> splitHeader(std::span<const std::byte> bytes) {
    if (bytes.size() < EncapsulationSize + HeaderSize) return std::nullopt;
    HeadedBody split;
    CdrReader in(bytes);
    in.read("client", split.header.client);
    in.read("number", split.header.number);
    if (!in.ok()) return std::nullopt;
    std::vector<std::byte> body(bytes.begin(), bytes.begin() + EncapsulationSize);
    const auto fields = bytes.subspan(EncapsulationSize + HeaderSize);
    body.insert(body.end(), fields.begin(), fields.end());
    split.body = std::make_shared<const std::vector<std::byte>>(std::move(body));
    return split;
}

}  // namespace leitstand
