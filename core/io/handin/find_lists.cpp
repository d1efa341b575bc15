#include "core/io/handin/find_lists.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/io/detail/input_file.h"
#include "core/io/detail/line_reader.h"
#include "core/io/detail/numbers.h"
#include "core/io/detail/output_file.h"
#include "core/io/handin/csv_fields.h"

namespace leitstand {
namespace {

/// Names of the rules for a kind of list.
struct Form {
    FindList::Kind kind;
    std::string_view type, version, ending, columns;
};
constexpr std::array<Form, 3> Forms = {
    {{FindList::Kind::Victims, "victims", "1.0", "_victims.csv", "id,time,name,x,y,z"},
     {FindList::Kind::Codes, "qr codes", "1.1", "_qr.csv", "id,time,text,x,y,z,robot,mode"},
     {FindList::Kind::Pois, "pois", "1.2", "_pois.csv", "id,time,text,x,y,z,robot,mode,type"}}};

const Form& formOf(FindList::Kind kind) {
    return *std::find_if(Forms.begin(), Forms.end(), [&](const Form& form) { return form.kind == kind; });
}

std::string metres(double value) {
    if (!std::isfinite(value)) return "nan";
    const std::string text = fmt::format("{:.3f}", value);
    return text == "-0.000" ? "0.000" : text;
}

/// Index of each column of a list, by name.
using Columns = std::map<std::string, std::size_t>;

std::string fieldOf(const std::vector<std::string>& fields, const Columns& columns, const std::string& name) {
    const auto column = columns.find(name);
    return column == columns.end() || column->second >= fields.size() ? "" : fields[column->second];
}

/// Parses the find of a row; returns what was expected instead, if anything.
std::optional<std::string> takeFind(const std::vector<std::string>& fields, const Columns& columns,
                                    ListedFind& find) {
    const auto id = detail::toCount(fieldOf(fields, columns, "id"));
    if (!id || *id > std::numeric_limits<std::uint32_t>::max()) return "a number as id";
    find.id = static_cast<std::uint32_t>(*id);
    find.time = fieldOf(fields, columns, "time");
    find.text = fieldOf(fields, columns, columns.contains("text") ? "text" : "name");
    find.robot = fieldOf(fields, columns, "robot");
    find.mode = fieldOf(fields, columns, "mode");
    find.type = detail::lowerCase(fieldOf(fields, columns, "type"));
    for (int axis = 0; axis < 3; ++axis) {
        const std::string name(1, static_cast<char>('x' + axis));
        const auto number = detail::toNumber(fieldOf(fields, columns, name));
        if (!number || !std::isfinite(*number)) {
            if (axis == 2 && fieldOf(fields, columns, name).empty()) continue;  // flat lists of earlier years
            return "a number as " + name;
        }
        find.position[axis] = *number;
    }
    return std::nullopt;
}

/// The lines before the columns: type, version, team, country, date, time, mission.
struct Head {
    std::vector<std::string> lines;
    Columns columns;
};

bool isColumns(const std::vector<std::string>& fields) {
    return fields.size() > 3 && detail::lowerCase(fields.front()) == "id";
}

Result<void> readHead(CsvReader& reader, Head& head) {
    std::vector<std::string> fields;
    while (reader.next(fields)) {
        if (isColumns(fields)) {
            for (std::size_t i = 0; i < fields.size(); ++i) head.columns[detail::lowerCase(fields[i])] = i;
            for (const char* name : {"id", "x", "y"}) {
                if (!head.columns.contains(name))
                    return reader.mismatch(fmt::format("a column \"{}\"", name));
            }
            return {};
        }
        // An unknown team or country is an empty line between others.
        const bool empty = fields.size() == 1 && fields.front().empty();
        if (!empty || !head.lines.empty()) head.lines.push_back(fields.front());
        if (head.lines.size() > 20) break;
    }
    if (const auto failure = reader.failure()) return *failure;
    return reader.mismatch("a line of columns that begins with \"id\"");
}

}  // namespace

std::string endingOf(FindList::Kind kind) {
    return std::string(formOf(kind).ending);
}

std::string textOf(const FindList& list) {
    const Form& form = formOf(list.kind);
    std::string text;
    for (const std::string_view line :
         {form.type, form.version, std::string_view(list.team), std::string_view(list.country),
          std::string_view(list.date), std::string_view(list.time), std::string_view(list.mission)}) {
        text += fmt::format("{}\n", quotedField(line));
    }
    text += fmt::format("\n{}\n", form.columns);
    for (const ListedFind& find : list.finds) {
        text += fmt::format("{},{},{},{},{},{}", find.id, csvField(find.time), csvField(find.text),
                            metres(find.position.x()), metres(find.position.y()), metres(find.position.z()));
        if (list.kind != FindList::Kind::Victims)
            text += fmt::format(",{},{}", csvField(find.robot), csvField(find.mode));
        if (list.kind == FindList::Kind::Pois) text += fmt::format(",{}", csvField(find.type));
        text += "\n";
    }
    return text;
}

Result<void> writeFindList(const std::filesystem::path& file, const FindList& list) {
    for (const ListedFind& find : list.finds) {
        if (!find.position.allFinite())
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: is not written: the position of {} is no number"),
                file.string(), find.id)};
    }
    return detail::writeWhole(file, textOf(list));
}

Result<FindList> readFindList(const std::filesystem::path& file) {
    auto opened = CsvReader::open(file);
    if (!opened) return opened.error();
    CsvReader reader = std::move(opened).value();
    Head head;
    if (const auto read = readHead(reader, head); !read) return read.error();
    FindList list;
    head.lines.resize(7);
    const std::string type = detail::lowerCase(head.lines[0]);
    const auto form =
        std::find_if(Forms.begin(), Forms.end(), [&](const Form& one) { return one.type == type; });
    if (form != Forms.end()) {
        list.kind = form->kind;
    } else if (head.columns.contains("type")) {
        list.kind = FindList::Kind::Pois;
    } else {
        list.kind = head.columns.contains("text") ? FindList::Kind::Codes : FindList::Kind::Victims;
    }
    list.team = head.lines[2];
    list.country = head.lines[3];
    list.date = head.lines[4];
    list.time = head.lines[5];
    list.mission = head.lines[6];
    std::vector<std::string> fields;
    while (reader.next(fields)) {
        if (fields.size() == 1 && fields.front().empty()) continue;
        ListedFind find;
        if (const auto expectation = takeFind(fields, head.columns, find))
            return reader.mismatch(*expectation);
        list.finds.push_back(std::move(find));
    }
    if (const auto failure = reader.failure()) return *failure;
    return list;
}

}  // namespace leitstand
