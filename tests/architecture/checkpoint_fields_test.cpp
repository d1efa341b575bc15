// A field of the state that a checkpoint does not hold is lost when a mission is resumed or jumped into, and
// no bytes show it: what checkpoint_fields.h names is compared with what the headers declare.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/sources.h"

namespace leitstand::test {
namespace {

/// @p text without comments, text literals and what stands in braces or parentheses, whose ends stay.
std::string flattened(const std::string& text) {
    static const std::regex aside(R"(//[^\n]*|"[^"\n]*")");
    std::string flat;
    int depth = 0;
    for (const char c : std::regex_replace(text, aside, "")) {
        if (c == '{' || c == '(') ++depth;
        if (depth == 0) flat += c == '\n' ? ' ' : c;
        if (c == '}' || c == ')') {
            if (--depth == 0) flat += c;
        }
    }
    return flat;
}

/// Text between the braces of "struct NAME {" in @p header; empty when it is not declared there.
std::string bodyOf(const std::string& header, const std::string& name) {
    const std::size_t at = header.find("struct " + name + " {");
    if (at == std::string::npos) return {};
    const std::size_t begin = header.find('{', at) + 1;
    std::size_t end = begin;
    for (int depth = 1; depth > 0; ++end) depth += header[end] == '{' ? 1 : header[end] == '}' ? -1 : 0;
    return header.substr(begin, end - begin - 1);
}

/// Names of the fields that a struct with this body has.
std::set<std::string> fieldsIn(const std::string& body) {
    static const std::regex kept(R"(^\s*(enum|struct|using|static|friend|template|\[\[))");
    static const std::regex brackets("<[^<>]*>"), last(R"((\w+)\s*\}?\s*$)");
    std::set<std::string> fields;
    std::string flat = flattened(body);
    std::size_t from = 0;
    for (std::size_t end = flat.find(';'); end != std::string::npos; end = flat.find(';', from)) {
        std::string statement = flat.substr(from, end - from);
        from = end + 1;
        const std::size_t call = statement.find(')'), value = statement.find('=');
        if (call < value) {  // a function: with a body, the next field may follow it
            const std::size_t body = statement.rfind('}');
            if (body == std::string::npos || body < call) continue;
            statement.erase(0, body + 1);
        }
        if (std::regex_search(statement, kept)) continue;
        for (std::string before; before != statement;)
            before = std::exchange(statement, std::regex_replace(statement, brackets, ""));
        for (std::size_t begin = 0; begin <= statement.size();) {
            const std::size_t comma = std::min(statement.find(',', begin), statement.size());
            std::string one = statement.substr(begin, comma - begin);
            one = one.substr(0, one.find('='));
            std::smatch name;
            if (std::regex_search(one, name, last)) fields.insert(name[1]);
            begin = comma + 1;
        }
    }
    return fields;
}

/// Fields by type, as checkpoint_fields.h describes them.
std::map<std::string, std::set<std::string>> described() {
    static const std::regex head(R"(void describe\(A& a, (\w+)& v\) \{)"), field(R"(\bv\.(\w+))");
    const std::string text = content("core/mission/state/checkpoint/checkpoint_fields.h");
    std::map<std::string, std::set<std::string>> all;
    for (std::sregex_iterator one(text.begin(), text.end(), head), none; one != none; ++one) {
        const auto from = static_cast<std::size_t>(one->position());
        const std::string body = text.substr(from, text.find("\n}", from) - from);
        for (std::sregex_iterator name(body.begin(), body.end(), field); name != none; ++name)
            all[(*one)[1]].insert((*name)[1]);
    }
    return all;
}

TEST(CheckpointFields, OfAStructAreFound) {
    EXPECT_THAT(fieldsIn(R"(
    enum class Kind { A, B };
    Time stamp{};  ///< station's clock; or not
    std::map<std::string, Pair<A, B>> first, second;
    double voltage = 0.0, current = nan(",");
    [[nodiscard]] bool full() const { return voltage > 1.0; }
    Kind kind = Kind::A;
    std::optional<Pose> there{};
    friend bool operator==(const X&, const X&) = default;
)"),
                testing::ElementsAre("current", "first", "kind", "second", "stamp", "there", "voltage"));
}

TEST(CheckpointFields, AreAllThatTheStateHas) {
    const std::map<std::string, std::set<std::string>> derived = {
        // What follows from the decisions ...
        {"Decision", {"undone"}},
        {"MissionState", {"finds", "keyScans", "loops", "bodies", "notes", "crop"}},
        // ... and what the fold does not keep.
        {"OdometrySample", {"poseCovariance", "twistCovariance"}},
        {"ImuSample",
         {"orientationCovariance", "angularVelocityCovariance", "linearAccelerationCovariance"}}};
    const auto all = described();
    EXPECT_GE(all.size(), 45U);
    std::vector<std::string> headers;
    for (const std::string& file : sources({"core/event", "core/mission/markers", "core/mission/state"}))
        if (file.ends_with(".h")) headers.push_back(content(file));
    for (const auto& [type, fields] : all) {
        std::set<std::string> declared;
        for (const std::string& header : headers) declared.merge(fieldsIn(bodyOf(header, type)));
        if (const auto known = derived.find(type); known != derived.end()) {
            for (const std::string& one : known->second) EXPECT_EQ(declared.erase(one), 1U) << one;
        }
        EXPECT_THAT(fields, testing::ContainerEq(declared)) << type;
    }
}

}  // namespace
}  // namespace leitstand::test
