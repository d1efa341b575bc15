#include "core/mission/state/checkpoint/checkpoint.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

// The fields come before the archive, whose templates look them up.
#include "core/mission/state/checkpoint/checkpoint_fields.h"

#include "core/mission/state/checkpoint/archive.h"
#include "core/mission/state/decisions.h"

namespace leitstand {

std::string runsOf(const std::vector<std::int8_t>& cells) {
    constexpr std::ptrdiff_t Longest = 0xffff;
    std::string runs;
    for (auto begin = cells.begin(); begin != cells.end();) {
        const auto limit = begin + std::min(Longest, cells.end() - begin);
        const auto end = std::find_if(begin, limit, [&](std::int8_t cell) { return cell != *begin; });
        const auto count = static_cast<std::uint16_t>(end - begin);
        runs += static_cast<char>(*begin);
        runs += static_cast<char>(count & 0xff);
        runs += static_cast<char>(count >> 8);
        begin = end;
    }
    return runs;
}

std::optional<std::vector<std::int8_t>> cellsOf(const std::string& runs, std::size_t count) {
    constexpr std::size_t Run = 3;
    std::vector<std::int8_t> cells;
    for (std::size_t i = 0; i + Run <= runs.size(); i += Run) {
        const auto low = static_cast<unsigned char>(runs[i + 1]),
                   high = static_cast<unsigned char>(runs[i + 2]);
        const std::size_t length = low + 256U * high;
        if (length == 0 || length > count - cells.size()) return std::nullopt;
        cells.insert(cells.end(), length, static_cast<std::int8_t>(runs[i]));
    }
    if (runs.size() % Run != 0 || cells.size() != count) return std::nullopt;
    return cells;
}

namespace {

constexpr std::uint32_t Magic = 0x534d534c;  // "LSMS"

/// FNV-1a over 64 bits: detects damage, not malice.
std::uint64_t checksum(std::span<const std::byte> bytes) {
    std::uint64_t sum = 14'695'981'039'346'656'037ULL;
    for (const std::byte byte : bytes)
        sum = (sum ^ std::to_integer<std::uint64_t>(byte)) * 1'099'511'628'211ULL;
    return sum;
}

bool rising(const std::vector<Decision>& decisions, std::uint64_t last) {
    return std::is_sorted(decisions.begin(), decisions.end(),
                          [](const Decision& a, const Decision& b) { return a.sequence <= b.sequence; }) &&
           (decisions.empty() || decisions.back().sequence <= last);
}

bool isRead(std::uint32_t version) {
    return version >= OldestCheckpointVersion && version <= CheckpointVersion;
}

}  // namespace

std::vector<std::byte> serialised(const MissionState& state) {
    Archive</*Writing=*/true> archive;
    std::uint32_t magic = Magic, version = CheckpointVersion;
    MissionState copy = state;  // shares all that is big
    archive(magic, version);
    archive.setVersion(version);
    archive(copy);
    std::vector<std::byte> bytes = archive.take();
    std::uint64_t sum = checksum(bytes);
    Archive</*Writing=*/true> tail;
    tail(sum);
    const auto end = tail.take();
    bytes.insert(bytes.end(), end.begin(), end.end());
    return bytes;
}

Result<MissionState> deserialised(std::span<const std::byte> bytes) {
    constexpr std::size_t Head = 8, Tail = 8;
    if (bytes.size() < Head + Tail) {
        return Error{
            fmt::format("checkpoint: expected at least {} bytes, found {}", Head + Tail, bytes.size())};
    }
    std::uint32_t magic = 0, version = 0;
    Archive</*Writing=*/false> archive(bytes.first(bytes.size() - Tail));
    archive(magic, version);
    if (magic != Magic || !isRead(version)) {
        return Error{fmt::format("checkpoint: expected version {} to {} of a mission's state, found {}",
                                 OldestCheckpointVersion, CheckpointVersion, magic == Magic ? version : 0)};
    }
    std::uint64_t sum = 0;
    Archive</*Writing=*/false>(bytes.last(Tail))(sum);
    if (sum != checksum(bytes.first(bytes.size() - Tail))) {
        return Error{"checkpoint: expected bytes that fit their checksum"};
    }
    MissionState state;
    archive.setVersion(version);
    archive(state);
    if (!archive.ok() || !archive.rest().empty()) {
        return Error{fmt::format("checkpoint: byte {}: expected a mission's state",
                                 bytes.size() - Tail - archive.rest().size())};
    }
    if (!rising(*state.decisions, state.sequence)) {
        return Error{"checkpoint: expected decisions of rising sequence"};
    }
    if (state.remarks->size() > MissionState::MaxRemarks) {
        return Error{fmt::format("checkpoint: expected at most {} remarks", MissionState::MaxRemarks)};
    }
    reconsider(state);
    return state;
}

CheckpointSample checkpointOf(const MissionState& state, Time stamp) {
    auto bytes = std::make_shared<const std::vector<std::byte>>(serialised(state));
    CheckpointSample checkpoint;
    checkpoint.stamp = stamp;
    checkpoint.sequence = state.sequence;
    checkpoint.version = CheckpointVersion;
    checkpoint.state = {bytes, std::span<const std::byte>(*bytes)};
    return checkpoint;
}

Result<MissionState> stateOf(const CheckpointSample& checkpoint) {
    if (!isRead(checkpoint.version)) {
        return Error{fmt::format("checkpoint after event {}: expected version {} to {}, found {}",
                                 checkpoint.sequence, OldestCheckpointVersion, CheckpointVersion,
                                 checkpoint.version)};
    }
    auto state = deserialised(checkpoint.state.bytes);
    if (state && state->sequence != checkpoint.sequence) {
        return Error{fmt::format("checkpoint after event {}: found the state after event {}",
                                 checkpoint.sequence, state->sequence)};
    }
    return state;
}

}  // namespace leitstand
