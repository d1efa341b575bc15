#include "core/io/robot/reading_reader.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "core/base/words.h"
#include "core/io/robot/robot_keys.h"

namespace leitstand::detail {
namespace {

constexpr int MostDecimals = 9;
constexpr double Largest = 1e12;  // of factors and limits

bool isWord(std::string_view text) {
    const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) == 0 &&
           std::all_of(text.begin(), text.end(), fits);
}

/// Whether @p text is a step of a path: "temperature", "cell_voltage[2]".
bool isStep(std::string_view text) {
    constexpr std::size_t MostDigits = 6;
    const auto open = text.find('[');
    if (open == std::string_view::npos) return isWord(text);
    const std::string_view index = text.substr(open + 1);
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    return isWord(text.substr(0, open)) && index.size() > 1 && index.size() <= MostDigits + 1 &&
           index.back() == ']' && std::all_of(index.begin(), index.end() - 1, isDigit);
}

bool isPath(std::string_view text) {
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto end = std::min(text.find('.', begin), text.size());
        if (!isStep(text.substr(begin, end - begin))) return false;
        begin = end + 1;
    }
    return true;
}

class ReadingReader {
public:
    explicit ReadingReader(YamlErrors& errors) : m_errors(errors) {}

    void read(const YamlPlace& place, std::vector<ReadingDescription>& readings) {
        const YamlFields fields(place, ReadingKeys, m_errors);
        if (!place.value.IsMap()) return;
        ReadingDescription reading;
        if (!readField(fields, reading.field)) return;
        reading.title = reading.field;
        fields.text("title", reading.title);
        fields.text("unit", reading.unit, true);
        fields.number("scale", reading.scale, -Largest, Largest, "");
        if (reading.scale == 0.0)
            fields.fail("scale", translate("leitstand::Error", "expected another number than 0"));
        fields.number("offset", reading.offset, -Largest, Largest, "");
        int decimals = 0;
        if (fields.has("decimals") && fields.count("decimals", decimals, 0, MostDecimals))
            reading.decimals = decimals;
        limit(fields, "low", reading.limits.low);
        limit(fields, "low_act", reading.limits.lowAct);
        limit(fields, "high", reading.limits.high);
        limit(fields, "high_act", reading.limits.highAct);
        checkOrder(fields, reading.limits);
        const auto same = std::find_if(readings.begin(), readings.end(),
                                       [&](const auto& one) { return one.title == reading.title; });
        if (same != readings.end())
            fields.fail(fields.has("title") ? "title" : "field",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected another title for each number, found {} again"),
                                        shown(reading.title)));
        readings.push_back(std::move(reading));
    }

private:
    static bool readField(const YamlFields& fields, std::string& field) {
        const char* const words = translatable("leitstand::Error",
                                               "expected the path of a number in the message, such as "
                                               "temperature or cells[2].voltage, found {}");
        if (!fields.has("field"))
            return fields.fail("field", leitstand::fill(translate("leitstand::Error", words),
                                                        translate("leitstand::Error", "nothing")));
        if (!fields.text("field", field)) return false;
        return isPath(field) ||
               fields.fail("field", leitstand::fill(translate("leitstand::Error", words), shown(field)));
    }

    static void limit(const YamlFields& fields, const char* key, std::optional<double>& to) {
        double value = 0.0;
        if (fields.has(key) && fields.number(key, value, -Largest, Largest, "")) to = value;
    }

    /// The limits must be in this order: low_act, low, high, high_act.
    static void checkOrder(const YamlFields& fields, const ReadingLimits& limits) {
        const std::pair<const char*, std::optional<double>> ordered[] = {{"low_act", limits.lowAct},
                                                                         {"low", limits.low},
                                                                         {"high", limits.high},
                                                                         {"high_act", limits.highAct}};
        const std::pair<const char*, std::optional<double>>* before = nullptr;
        for (const auto& one : ordered) {
            if (!one.second) continue;
            if (before != nullptr && *one.second < *before->second)
                fields.fail(one.first,
                            leitstand::fill(translate("leitstand::Error",
                                                      "expected at least {} (that of {}), found \"{}\""),
                                            *before->second, before->first, *one.second));
            before = &one;
        }
    }

    YamlErrors& m_errors;
};

}  // namespace

bool isTypeName(std::string_view text) {
    constexpr std::string_view Middle = "/msg/";
    const auto at = text.find(Middle);
    return at != std::string_view::npos && isWord(text.substr(0, at)) &&
           isWord(text.substr(at + Middle.size()));
}

void readReadings(const YamlFields& fields, StreamDescription& stream, YamlErrors& errors) {
    if (!fields.has("readings")) {
        stream.readings = usualReadings(stream.type);
        if (stream.readings.empty())
            fields.fail("readings",
                        leitstand::fill(translate("leitstand::Error",
                                                  "expected a list of numbers in messages of type "
                                                  "{}, found nothing"),
                                        stream.type));
        return;
    }
    const std::vector<YamlPlace> places = fields.list("readings");
    if (places.empty() || places.size() > ReadingDescription::MostOfATopic) {
        fields.fail("readings",
                    leitstand::fill(translate("leitstand::Error", "expected 1 to {} numbers, found {}"),
                                    ReadingDescription::MostOfATopic, places.size()));
        return;
    }
    ReadingReader reader(errors);
    for (const YamlPlace& place : places) reader.read(place, stream.readings);
}

}  // namespace leitstand::detail
