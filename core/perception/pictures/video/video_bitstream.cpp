#include "core/perception/pictures/video/video_bitstream.h"

#include <algorithm>
#include <array>
#include <vector>

namespace leitstand {
namespace {

// nal_unit_type, ITU-T H.264 table 7-1
constexpr unsigned Slice = 1, SliceOfIdr = 5, SequenceParameters = 7;
// nal_unit_type, ITU-T H.265 table 7-1
constexpr unsigned FirstRandomAccess = 16, LastRandomAccess = 21;
constexpr std::size_t MostOfUnit = 512;  ///< bytes of a unit that are looked at; its head is shorter

unsigned valueOf(std::byte byte) {
    return std::to_integer<unsigned>(byte);
}

/// Calls @p use(unit without its start code) for the NAL units in @p bytes, until it returns false.
template <class Use>
void forEachUnit(std::span<const std::byte> bytes, Use use) {
    const auto isStart = [&](std::size_t at) {
        return valueOf(bytes[at]) == 0 && valueOf(bytes[at + 1]) == 0 && valueOf(bytes[at + 2]) == 1;
    };
    std::optional<std::size_t> begin;
    for (std::size_t at = 0; at + 3 <= bytes.size(); ++at) {
        if (!isStart(at)) continue;
        if (begin && at > *begin && !use(bytes.subspan(*begin, at - *begin))) return;
        begin = at + 3;
        at += 2;
    }
    if (begin && *begin < bytes.size()) (void)use(bytes.subspan(*begin));
}

/// Reads the head of a NAL unit bit by bit (ITU-T H.264 7.2 and 9.1). Past the end it reads zeros and is not
/// good any more.
class BitReader {
public:
    explicit BitReader(std::span<const std::byte> unit) {
        // A 3 after two zeros only prevents that a start code appears (7.4.1.1).
        int zeros = 0;
        for (const std::byte byte : unit.first(std::min(unit.size(), MostOfUnit))) {
            if (zeros >= 2 && valueOf(byte) == 3) {
                zeros = 0;
                continue;
            }
            zeros = valueOf(byte) == 0 ? zeros + 1 : 0;
            m_bytes.push_back(byte);
        }
    }

    [[nodiscard]] bool good() const { return m_good; }
    std::uint32_t bits(int count) {
        std::uint32_t value = 0;
        for (int i = 0; i < count; ++i) value = value << 1U | bit();
        return value;
    }
    /// ue(v): Exp-Golomb, unsigned.
    std::uint32_t number() {
        int zeros = 0;
        while (m_good && zeros < 32 && bit() == 0) ++zeros;
        if (zeros >= 32) m_good = false;
        return m_good ? (std::uint32_t{1} << static_cast<unsigned>(zeros)) - 1 + bits(zeros) : 0;
    }
    /// se(v): Exp-Golomb, signed.
    std::int64_t difference() {
        const std::uint32_t code = number();
        return code % 2 == 1 ? (std::int64_t{code} + 1) / 2 : -(std::int64_t{code} / 2);
    }

private:
    std::uint32_t bit() {
        const std::size_t byte = m_at / 8;
        if (byte >= m_bytes.size()) {
            m_good = false;
            return 0;
        }
        return valueOf(m_bytes[byte]) >> (7 - m_at++ % 8) & 1U;
    }

    std::vector<std::byte> m_bytes;
    std::size_t m_at = 0;  ///< [bits]
    bool m_good = true;
};

/// Passes over a scaling list (ITU-T H.264 7.3.2.1.1.1).
void passScalingList(BitReader& in, int size) {
    std::int64_t last = 8, next = 8;
    for (int i = 0; i < size && in.good(); ++i) {
        if (next != 0) next = (last + in.difference() + 256) % 256;
        last = next == 0 ? last : next;
    }
}

/// Whether the parameters of a sequence with @p profile tell its format of colours (ITU-T H.264 7.3.2.1.1).
bool tellsColours(unsigned profile) {
    constexpr std::array<unsigned, 13> All = {100, 110, 122, 244, 44, 83, 86, 118, 128, 138, 139, 134, 135};
    return std::find(All.begin(), All.end(), profile) != All.end();
}

}  // namespace

std::optional<VideoCodec> videoCodecOf(std::string_view name) {
    const auto has = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
    if (has("264")) return VideoCodec::H264;
    if (has("265") || has("hevc")) return VideoCodec::H265;
    return std::nullopt;
}

bool hasStartCode(std::span<const std::byte> bytes) {
    std::size_t zeros = 0;
    while (zeros < bytes.size() && zeros < 4 && valueOf(bytes[zeros]) == 0) ++zeros;
    return zeros >= 2 && zeros < bytes.size() && valueOf(bytes[zeros]) == 1;
}

bool isKeyPicture(VideoCodec codec, std::span<const std::byte> bytes) {
    bool key = false;
    forEachUnit(bytes, [&](std::span<const std::byte> unit) {
        const unsigned head = valueOf(unit.front());
        if (codec == VideoCodec::H264) {
            key = (head & 31U) == SliceOfIdr;
        } else {
            const unsigned type = head >> 1U & 63U;
            key = type >= FirstRandomAccess && type <= LastRandomAccess;
        }
        return !key;
    });
    return key;
}

VideoContents contentsOf(VideoCodec codec, std::span<const std::byte> bytes) {
    constexpr unsigned LastSlice = 5, LastPicture = 31, SequenceParameters265 = 33;
    VideoContents contents;
    forEachUnit(bytes, [&](std::span<const std::byte> unit) {
        const unsigned head = valueOf(unit.front());
        const bool h264 = codec == VideoCodec::H264;
        const unsigned type = h264 ? head & 31U : head >> 1U & 63U;
        contents.picture =
            contents.picture || (h264 ? type >= Slice && type <= LastSlice : type <= LastPicture);
        contents.parameters =
            contents.parameters || type == (h264 ? SequenceParameters : SequenceParameters265);
        return true;
    });
    return contents;
}

std::optional<PictureNumbers::Parameters> PictureNumbers::parametersIn(std::span<const std::byte> unit) {
    Parameters found;
    BitReader in(unit.subspan(1));
    const unsigned profile = in.bits(8);
    in.bits(16);  // constraints, level
    in.number();  // seq_parameter_set_id
    if (tellsColours(profile)) {
        const std::uint32_t colours = in.number();
        if (colours == 3) found.separatePlanes = in.bits(1) != 0;
        in.number();  // bit depths
        in.number();
        in.bits(1);
        if (in.bits(1) != 0) {
            for (int i = 0; i < (colours == 3 ? 12 : 8); ++i)
                if (in.bits(1) != 0) passScalingList(in, i < 6 ? 16 : 64);
        }
    }
    const std::uint32_t bits = in.number() + 4;
    if (bits > 16) return std::nullopt;
    found.numberBits = static_cast<int>(bits);
    const std::uint32_t order = in.number();  // pic_order_cnt_type
    if (order == 0) in.number();
    if (order == 1) {
        in.bits(1);
        in.difference();
        in.difference();
        const std::uint32_t cycle = in.number();
        for (std::uint32_t i = 0; i < cycle && in.good(); ++i) in.difference();
    }
    in.number();  // max_num_ref_frames
    found.gapsAllowed = in.bits(1) != 0;
    return in.good() ? std::optional(found) : std::nullopt;
}

bool PictureNumbers::follows(VideoCodec codec, std::span<const std::byte> bytes) {
    if (codec != VideoCodec::H264) return true;
    bool complete = true;
    forEachUnit(bytes, [&](std::span<const std::byte> unit) {
        const unsigned head = valueOf(unit.front()), type = head & 31U;
        const bool reference = (head >> 5U & 3U) != 0;
        if (type == SequenceParameters) m_parameters = parametersIn(unit);
        if (type != Slice && type != SliceOfIdr) return true;
        if (!m_parameters) return false;
        BitReader in(unit.subspan(1));
        in.number();  // first_mb_in_slice
        in.number();  // slice_type
        in.number();  // pic_parameter_set_id
        if (m_parameters->separatePlanes) in.bits(2);
        const std::uint32_t number = in.bits(m_parameters->numberBits);
        if (!in.good()) return false;
        const std::uint32_t most = (1U << static_cast<unsigned>(m_parameters->numberBits)) - 1;
        if (type == Slice && m_reference && !m_parameters->gapsAllowed)
            complete = number == *m_reference || number == ((*m_reference + 1) & most);
        if (reference || type == SliceOfIdr) m_reference = number;
        return false;  // other slices of the picture have the same number
    });
    return complete;
}

}  // namespace leitstand
