#include "robots/simulation/arena/mesh/qr_code.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include <fmt/format.h>

namespace leitstand::simulation {
namespace {

/// What a version holds with error correction M: table 9 of the standard.
struct Version {
    int number;
    int blocks;
    int dataInBlock;        ///< codewords
    int correctionInBlock;  ///< codewords
    int alignment;          ///< centre of the one alignment pattern; 0: none

    [[nodiscard]] int edge() const { return 17 + 4 * number; }
    /// Bytes of text: mode (4 bits) and length (8 bits) come before them.
    [[nodiscard]] std::size_t room() const { return static_cast<std::size_t>(blocks * dataInBlock - 2); }
};
constexpr std::array<Version, 4> Versions = {
    {{1, 1, 16, 10, 0}, {2, 1, 28, 16, 18}, {3, 1, 44, 26, 22}, {4, 2, 32, 18, 26}}};

/// Product in GF(256) modulo x^8 + x^4 + x^3 + x^2 + 1.
std::uint8_t product(std::uint8_t a, std::uint8_t b) {
    unsigned sum = 0;
    for (int bit = 7; bit >= 0; --bit) {
        sum = (sum << 1U) ^ ((sum >> 7U) * 0x11DU);
        if (((b >> static_cast<unsigned>(bit)) & 1U) != 0) sum ^= a;
    }
    return static_cast<std::uint8_t>(sum);
}

/// The generator's coefficients without the leading one, highest first.
std::vector<std::uint8_t> generatorOf(int degree) {
    std::vector<std::uint8_t> generator(static_cast<std::size_t>(degree), 0);
    generator.back() = 1;
    std::uint8_t root = 1;
    for (int i = 0; i < degree; ++i) {
        for (std::size_t j = 0; j < generator.size(); ++j) {
            generator[j] = product(generator[j], root);
            if (j + 1 < generator.size()) generator[j] ^= generator[j + 1];
        }
        root = product(root, 2);
    }
    return generator;
}

/// The remainder of Reed and Solomon.
std::vector<std::uint8_t> correctionOf(const std::vector<std::uint8_t>& data, int count) {
    const std::vector<std::uint8_t> generator = generatorOf(count);
    std::vector<std::uint8_t> rest(generator.size(), 0);
    for (const std::uint8_t byte : data) {
        const std::uint8_t factor = byte ^ rest.front();
        rest.erase(rest.begin());
        rest.push_back(0);
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] ^= product(generator[i], factor);
    }
    return rest;
}

/// All codewords in the order in which they are drawn.
std::vector<std::uint8_t> codewordsOf(std::string_view text, const Version& version) {
    const auto size = static_cast<std::size_t>(version.blocks * version.dataInBlock);
    // Mode 4 (bytes), the length, the text: shifted by the half byte of the mode.
    std::vector<std::uint8_t> data;
    unsigned half = 4;
    const auto push = [&](unsigned byte) {
        data.push_back(static_cast<std::uint8_t>((half << 4U) | (byte >> 4U)));
        half = byte & 0xFU;
    };
    push(static_cast<unsigned>(text.size()));
    for (const char one : text) push(static_cast<unsigned char>(one));
    push(0);  // the end; its second half is room
    for (bool odd = false; data.size() < size; odd = !odd) data.push_back(odd ? 0x11 : 0xEC);
    data.resize(size);

    const auto blockSize = static_cast<std::size_t>(version.dataInBlock);
    std::vector<std::vector<std::uint8_t>> blocks;
    std::vector<std::vector<std::uint8_t>> corrections;
    for (std::size_t begin = 0; begin < size; begin += blockSize) {
        const auto from = data.begin() + static_cast<std::ptrdiff_t>(begin);
        blocks.emplace_back(from, from + static_cast<std::ptrdiff_t>(blockSize));
        corrections.push_back(correctionOf(blocks.back(), version.correctionInBlock));
    }
    std::vector<std::uint8_t> all;
    for (const auto* lists : {&blocks, &corrections}) {
        for (std::size_t i = 0; i < lists->front().size(); ++i) {
            for (const auto& list : *lists) all.push_back(list[i]);
        }
    }
    return all;
}

class Drawing {
public:
    explicit Drawing(const Version& version) : m_edge(version.edge()) {
        m_code.edge = m_edge;
        m_code.black.assign(static_cast<std::size_t>(m_edge * m_edge), 0);
        m_fixed.assign(m_code.black.size(), 0);
        for (int i = 0; i < m_edge; ++i) {
            fix(6, i, i % 2 == 0);
            fix(i, 6, i % 2 == 0);
        }
        finder(3, 3);
        finder(3, m_edge - 4);
        finder(m_edge - 4, 3);
        if (version.alignment > 0) pattern(version.alignment, version.alignment, 2, {0, 2});
        format(0);  // reserves its place
    }

    void draw(const std::vector<std::uint8_t>& codewords) {
        std::size_t bit = 0;
        bool upwards = true;
        for (int right = m_edge - 1; right >= 1; right -= 2, upwards = !upwards) {
            if (right == 6) right = 5;  // the column of the timing pattern
            for (int i = 0; i < m_edge; ++i) {
                const int row = upwards ? m_edge - 1 - i : i;
                for (const int column : {right, right - 1}) {
                    if (m_fixed[place(row, column)] != 0 || bit >= 8 * codewords.size()) continue;
                    m_code.black[place(row, column)] =
                        static_cast<char>((codewords[bit / 8] >> (7U - static_cast<unsigned>(bit % 8))) & 1U);
                    ++bit;
                }
            }
        }
    }

    /// Turns modules over where @p mask says so. Twice: as before.
    void apply(int mask) {
        for (int y = 0; y < m_edge; ++y) {
            for (int x = 0; x < m_edge; ++x) {
                if (m_fixed[place(y, x)] == 0 && masked(mask, y, x)) m_code.black[place(y, x)] ^= 1;
            }
        }
    }

    void format(int mask) {
        // Error correction M is 00; a BCH code and a fixed pattern follow.
        const auto data = static_cast<unsigned>(mask);
        unsigned rest = data;
        for (int i = 0; i < 10; ++i) rest = (rest << 1U) ^ ((rest >> 9U) * 0x537U);
        const unsigned bits = ((data << 10U) | rest) ^ 0x5412U;
        const auto bit = [bits](int i) { return ((bits >> static_cast<unsigned>(i)) & 1U) != 0; };
        for (int i = 0; i <= 5; ++i) fix(i, 8, bit(i));
        fix(7, 8, bit(6));
        fix(8, 8, bit(7));
        fix(8, 7, bit(8));
        for (int i = 9; i < 15; ++i) fix(8, 14 - i, bit(i));
        for (int i = 0; i < 8; ++i) fix(8, m_edge - 1 - i, bit(i));
        for (int i = 8; i < 15; ++i) fix(m_edge - 15 + i, 8, bit(i));
        fix(m_edge - 8, 8, true);
    }

    /// How badly it can be read: runs, blocks and the balance of black and white.
    [[nodiscard]] int penalty() const {
        int sum = 0;
        int black = 0;
        for (int i = 0; i < m_edge; ++i) {
            sum +=
                runs([&](int j) { return m_code.at(i, j); }) + runs([&](int j) { return m_code.at(j, i); });
            for (int j = 0; j < m_edge; ++j) {
                black += m_code.at(i, j) ? 1 : 0;
                if (i == 0 || j == 0) continue;
                const bool one = m_code.at(i, j);
                if (one == m_code.at(i - 1, j) && one == m_code.at(i, j - 1) &&
                    one == m_code.at(i - 1, j - 1))
                    sum += 3;
            }
        }
        return sum + 10 * (std::abs(20 * black - 10 * m_edge * m_edge) / (m_edge * m_edge));
    }
    [[nodiscard]] const QrCode& code() const { return m_code; }

private:
    [[nodiscard]] std::size_t place(int row, int column) const {
        return static_cast<std::size_t>(row * m_edge + column);
    }
    void fix(int row, int column, bool black) {
        m_code.black[place(row, column)] = black ? 1 : 0;
        m_fixed[place(row, column)] = 1;
    }
    /// Squares around a centre; black at the distances @p black.
    void pattern(int row, int column, int reach, std::initializer_list<int> black) {
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                if (row + y < 0 || column + x < 0 || row + y >= m_edge || column + x >= m_edge) continue;
                const int ring = std::max(std::abs(x), std::abs(y));
                bool dark = false;
                for (const int one : black) dark = dark || one == ring;
                fix(row + y, column + x, dark);
            }
        }
    }
    void finder(int row, int column) { pattern(row, column, 4, {0, 1, 3}); }

    static bool masked(int mask, int y, int x) {
        switch (mask) {
            case 0:
                return (x + y) % 2 == 0;
            case 1:
                return y % 2 == 0;
            case 2:
                return x % 3 == 0;
            case 3:
                return (x + y) % 3 == 0;
            case 4:
                return (x / 3 + y / 2) % 2 == 0;
            case 5:
                return x * y % 2 + x * y % 3 == 0;
            case 6:
                return (x * y % 2 + x * y % 3) % 2 == 0;
            default:
                return ((x + y) % 2 + x * y % 3) % 2 == 0;
        }
    }

    template <class Module>
    [[nodiscard]] int runs(const Module& module) const {
        int sum = 0;
        int length = 0;
        for (int i = 0; i < m_edge; ++i) {
            length = i > 0 && module(i) == module(i - 1) ? length + 1 : 1;
            sum += length == 5 ? 3 : (length > 5 ? 1 : 0);
        }
        // What looks like a finder: 1011101 with four white ones on a side.
        for (int i = 0; i + 7 <= m_edge; ++i) {
            bool like = true;
            for (int j = 0; j < 7; ++j) like = like && module(i + j) == (j != 1 && j != 5);
            if (!like) continue;
            for (const int side : {i - 4, i + 7}) {
                bool white = true;
                for (int j = side; j < side + 4; ++j) white = white && (j < 0 || j >= m_edge || !module(j));
                sum += white ? 40 : 0;
            }
        }
        return sum;
    }

    int m_edge;
    QrCode m_code;
    std::vector<char> m_fixed;
};

}  // namespace

Result<QrCode> encodeQr(std::string_view text) {
    for (const Version& version : Versions) {
        if (text.size() > version.room()) continue;
        Drawing drawing(version);
        drawing.draw(codewordsOf(text, version));
        int best = 0;
        int least = std::numeric_limits<int>::max();
        for (int mask = 0; mask < 8; ++mask) {
            drawing.apply(mask);
            drawing.format(mask);
            const int penalty = drawing.penalty();
            drawing.apply(mask);
            if (penalty < least) {
                least = penalty;
                best = mask;
            }
        }
        drawing.apply(best);
        drawing.format(best);
        return drawing.code();
    }
    return Error{fmt::format("a QR code: expected at most {} bytes, found {}", LongestQrText, text.size())};
}

}  // namespace leitstand::simulation
