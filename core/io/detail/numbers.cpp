#include "core/io/detail/numbers.h"

#include <array>
#include <charconv>

namespace leitstand::detail {

namespace {

bool separates(char c, Separators separators) {
    if (c == ' ' || c == '\t' || c == '\r') return true;
    return separators == Separators::BlanksAndCommas && (c == ',' || c == ';');
}

template <class... Arguments>
void append(std::string& text, Arguments... arguments) {
    std::array<char, 40> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), arguments...);
    text.append(digits.data(), end.ptr);
}

}  // namespace

std::string_view takeField(std::string_view& line, Separators separators) {
    std::size_t begin = 0;
    while (begin < line.size() && separates(line[begin], separators)) ++begin;
    std::size_t end = begin;
    while (end < line.size() && !separates(line[end], separators)) ++end;
    const std::string_view field = line.substr(begin, end - begin);
    line.remove_prefix(end);
    return field;
}

std::optional<double> toNumber(std::string_view field) {
    if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
    double value = 0.0;
    const char* end = field.data() + field.size();
    const auto parsed = std::from_chars(field.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    return value;
}

std::optional<std::size_t> toCount(std::string_view field) {
    std::size_t value = 0;
    const char* end = field.data() + field.size();
    const auto parsed = std::from_chars(field.data(), end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    return value;
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return lower;
}

void appendNumber(std::string& text, float value) {
    append(text, value);
}

void appendNumber(std::string& text, double value) {
    append(text, value);
}

void appendCentimetres(std::string& text, float metres) {
    const double centimetres = static_cast<double>(metres) * 100.0;
    const std::size_t before = text.size();
    append(text, static_cast<float>(centimetres));
    const auto back = toNumber(std::string_view(text).substr(before));
    if (back && static_cast<float>(*back / 100.0) == metres) return;
    // Nine digits distinguish any two floats, in any unit.
    text.resize(before);
    append(text, centimetres, std::chars_format::general, 9);
}

}  // namespace leitstand::detail
