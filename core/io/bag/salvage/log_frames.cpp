#include "core/io/bag/salvage/log_frames.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/io/bag/salvage/big_endian.h"

namespace leitstand::detail {

namespace {

constexpr std::int64_t LogHeader = 32, FrameHeader = 24;
/// A log begins each new round over the old one, so old frames stay behind the new ones. In each round SQLite
/// adds 1 to the first of two numbers that all frames of the round share. No log has more rounds.
constexpr std::uint32_t MostRounds = 10'000'000;

/// The checksum of a log, over 32-bit words in the byte order that its header names.
struct LogChecksum {
    std::uint32_t a = 0, b = 0;
    bool big = false;

    void add(std::span<const std::byte> bytes) {
        for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
            a += word(bytes.subspan(i)) + b;
            b += word(bytes.subspan(i + 4)) + a;
        }
    }
    [[nodiscard]] std::uint32_t word(std::span<const std::byte> bytes) const {
        const std::uint32_t value = bigEndian32(bytes);
        return big ? value : __builtin_bswap32(value);
    }
    friend bool operator==(const LogChecksum&, const LogChecksum&) = default;
};

/// The two numbers that all frames of a round share.
struct Round {
    std::uint32_t count = 0, random = 0;
    friend bool operator==(const Round&, const Round&) = default;
};

struct Frame {
    std::uint32_t page = 0;
    bool commits = false;
    Round round;
    LogChecksum stated;
};

class Walk {
public:
    Walk(const OverlayFile& log, std::size_t pageSize)
        : m_log(log), m_bytes(static_cast<std::size_t>(FrameHeader) + pageSize) {}

    LogFrames result(std::size_t pageSize) {
        if (m_log.size() < LogHeader) return {};
        if (!readHeader(pageSize)) {
            if (!guessRound()) return {};
            m_found.firstBroken = 0;
            m_stopped = true;
        }
        std::int64_t at = LogHeader;
        for (std::size_t i = 1; at + size() <= m_log.size(); at += size(), ++i) {
            if (!readFrame(at) || !take(i, at)) return finished(false);
        }
        return finished(at < m_log.size() && m_inRound);
    }

private:
    [[nodiscard]] std::int64_t size() const { return std::ssize(m_bytes); }

    bool readHeader(std::size_t pageSize) {
        std::array<std::byte, LogHeader> header{};
        if (!m_log.read(0, header)) return false;
        const std::span<const std::byte> fields(header);
        const std::uint32_t magic = bigEndian32(fields);
        LogChecksum sum{.big = (magic & 1U) != 0};
        sum.add(fields.first(24));
        if ((magic & ~1U) != 0x377f0682U || bigEndian32(fields.subspan(8)) % 65'536 != pageSize % 65'536 ||
            sum.a != bigEndian32(fields.subspan(24)) || sum.b != bigEndian32(fields.subspan(28)))
            return false;
        m_round = {bigEndian32(fields.subspan(16)), bigEndian32(fields.subspan(20))};
        m_before = m_computed = sum;
        m_inRound = true;
        return true;
    }

    /// Without a header, takes the round of the first frame if the second frame continues it, in either byte
    /// order. The first frame itself cannot be verified.
    bool guessRound() {
        if (!readFrame(LogHeader)) return false;
        const Frame first = m_frame;
        if (LogHeader + 2 * size() > m_log.size() || !readFrame(LogHeader + size())) return false;
        for (const bool big : {false, true}) {
            LogChecksum sum = first.stated;
            sum.big = big;
            if (m_frame.round != first.round || !continues(sum)) continue;
            m_round = first.round;
            m_before = m_computed = {.a = ~first.stated.a, .b = 0, .big = big};  // matches no first frame
            return true;
        }
        return false;
    }

    bool readFrame(std::int64_t at) {
        if (at + size() > m_log.size() || !m_log.read(at, m_bytes)) return false;
        const std::span<const std::byte> bytes(m_bytes);
        m_frame.page = bigEndian32(bytes);
        m_frame.commits = bigEndian32(bytes.subspan(4)) != 0;
        m_frame.round = {bigEndian32(bytes.subspan(8)), bigEndian32(bytes.subspan(12))};
        m_frame.stated = {bigEndian32(bytes.subspan(16)), bigEndian32(bytes.subspan(20)), m_before.big};
        return true;
    }

    /// Whether the frame's checksum continues @p sum, which becomes the frame's own.
    bool continues(LogChecksum& sum) const {
        const std::span<const std::byte> bytes(m_bytes);
        sum.add(bytes.first(8));
        sum.add(bytes.subspan(FrameHeader));
        return sum.a == m_frame.stated.a && sum.b == m_frame.stated.b;
    }

    /// Takes frame @p number at offset @p at; false at the end of the round.
    bool take(std::size_t number, std::int64_t at) {
        LogChecksum stated = m_before, computed = m_computed;
        const bool fitsStated = continues(stated);
        const bool fits = m_frame.page != 0 && (fitsStated || continues(computed));
        const bool member = m_frame.round == m_round;
        if (!member && !(fits && m_inRound) && isOlder(m_frame.round)) return false;
        m_inRound = true;
        m_computed = fitsStated ? stated : computed;
        m_before = m_frame.stated;
        // SQLite requires both: the numbers of the round, and the checksum.
        if (!m_stopped && !(fits && member)) {
            m_stopped = true;
            m_found.firstBroken = number;
        }
        m_last = fits;
        if (!fits) {
            ++m_found.broken;
            return true;
        }
        ++m_found.sound;
        m_pending[m_frame.page] = at + FrameHeader;
        if (m_stopped) ++m_pendingHidden;
        if (!m_frame.commits) return true;
        for (const auto& [page, offset] : m_pending) m_found.pages[page] = offset;
        m_found.hidden += m_pendingHidden;
        m_pending.clear();
        m_pendingHidden = 0;
        return true;
    }

    [[nodiscard]] bool isOlder(const Round& round) const {
        const std::uint32_t rounds = m_round.count - round.count;
        return rounds > 0 && rounds < MostRounds;
    }

    LogFrames finished(bool rest) {
        m_found.cut = rest || !m_pending.empty() || (m_found.sound + m_found.broken > 0 && !m_last);
        return std::move(m_found);
    }

    const OverlayFile& m_log;
    std::vector<std::byte> m_bytes;  // of a frame
    Frame m_frame;
    Round m_round;
    LogChecksum m_before, m_computed;                 // checksum of the frame before: stored, computed
    bool m_inRound = false;                           // that frame belongs to the round
    bool m_last = false;                              // that frame is sound
    bool m_stopped = false;                           // SQLite reads no further
    std::map<std::uint32_t, std::int64_t> m_pending;  // of a transaction not committed yet
    std::size_t m_pendingHidden = 0;
    LogFrames m_found;
};

}  // namespace

LogFrames logFrames(const OverlayFile& log, std::size_t pageSize) {
    return Walk(log, pageSize).result(pageSize);
}

}  // namespace leitstand::detail
