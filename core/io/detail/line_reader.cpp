#include "core/io/detail/line_reader.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace leitstand::detail {

namespace {
constexpr std::size_t ChunkSize = 1 << 18;

/// Returns the size of a chunk; for a smaller file, its size and one byte to detect its end.
std::size_t bufferFor(const InputFile& file) {
    return static_cast<std::size_t>(std::min<std::uint64_t>(ChunkSize, file.size() + 1));
}
}  // namespace

Result<LineReader> LineReader::open(const std::filesystem::path& path) {
    auto file = InputFile::open(path);
    if (!file) return file.error();
    return LineReader(std::move(file).value());
}

LineReader::LineReader(InputFile file) : m_file(std::move(file)), m_buffer(bufferFor(m_file)) {}

bool LineReader::next(std::string_view& line) {
    std::size_t searched = 0;
    while (true) {
        const char* begin = m_buffer.data() + m_begin;
        const std::size_t available = m_end - m_begin;
        const auto* end = static_cast<const char*>(std::memchr(begin + searched, '\n', available - searched));
        std::size_t length = end != nullptr ? static_cast<std::size_t>(end - begin) : available;
        if (length > MaxLine) {
            m_failure = Error{fmt::format("{}:{}: expected lines of at most {} bytes", m_file.path().string(),
                                          m_lineNumber + 1, MaxLine)};
            return false;
        }
        if (end == nullptr && !m_atEnd) {
            searched = available;
            if (!refill()) return false;
            continue;
        }
        if (end == nullptr && available == 0) return false;
        const std::size_t step = end != nullptr ? length + 1 : length;
        m_begin += step;
        m_taken += step;
        ++m_lineNumber;
        if (length > 0 && begin[length - 1] == '\r') --length;
        line = std::string_view(begin, length);
        return true;
    }
}

bool LineReader::refill() {
    std::copy(m_buffer.begin() + static_cast<std::ptrdiff_t>(m_begin),
              m_buffer.begin() + static_cast<std::ptrdiff_t>(m_end), m_buffer.begin());
    m_end -= m_begin;
    m_begin = 0;
    const std::size_t wanted = m_buffer.size() - m_end;
    const auto got = m_file.read(m_buffer.data() + m_end, wanted);
    if (!got) {
        m_failure = got.error();
        return false;
    }
    m_end += *got;
    m_atEnd = *got < wanted || wanted == 0;  // no room: the file grows while it is read
    return true;
}

Error LineReader::mismatch(std::string_view expectation, std::string_view found) const {
    return Error{fmt::format("{}:{}: expected {}, found \"{}\"", m_file.path().string(), m_lineNumber,
                             expectation, quotable(found))};
}

Error LineReader::incomplete(std::string_view expectation) const {
    return Error{fmt::format("{}: expected {}", m_file.path().string(), expectation)};
}

Result<std::size_t> countLines(const std::filesystem::path& path) {
    auto file = InputFile::open(path);
    if (!file) return file.error();
    InputFile in = std::move(file).value();
    std::vector<char> buffer(bufferFor(in));
    std::size_t lines = 1;
    while (true) {
        const auto got = in.read(buffer.data(), buffer.size());
        if (!got) return got.error();
        lines += static_cast<std::size_t>(
            std::count(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(*got), '\n'));
        if (*got < buffer.size()) return lines;
    }
}

std::string quotable(std::string_view text) {
    constexpr std::size_t Longest = 40;
    std::string quoted;
    for (const char c : text.substr(0, Longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f) {
            quoted += c;
        } else {
            quoted += fmt::format("\\x{:02x}", byte);
        }
    }
    if (text.size() > Longest) quoted += "...";
    return quoted;
}

}  // namespace leitstand::detail
