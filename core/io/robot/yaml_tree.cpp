#include "core/io/robot/yaml_tree.h"

#include <istream>
#include <streambuf>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace leitstand::detail {
namespace {

constexpr std::size_t MaxDepth = 16;
constexpr int MaxNodes = 20'000;

/// Thrown through yaml-cpp's parser, which knows no other way to stop.
struct Refusal {
    int line;
    std::string text;
};

int lineOf(const YAML::Mark& mark) {
    return mark.line + 1;
}

/// Builds the tree. Values under construction stand on a stack of their own, not in the tree.
class TreeBuilder final : public YAML::EventHandler {
public:
    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
        YamlNode node = begin(mark, YamlNode::Kind::Null);
        add(std::move(node));
    }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw Refusal{lineOf(mark), "aliases (*name) are not read: write the value out"};
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  const std::string& value) override {
        refuseTag(mark, tag);
        const bool plain = tag != "!";
        const bool null = plain && (value == "~" || value == "null");
        YamlNode node = begin(mark, null ? YamlNode::Kind::Null : YamlNode::Kind::Scalar);
        node.scalar = value;
        add(std::move(node));
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                         YAML::EmitterStyle::value) override {
        refuseTag(mark, tag);
        open(begin(mark, YamlNode::Kind::List));
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                    YAML::EmitterStyle::value) override {
        refuseTag(mark, tag);
        open(begin(mark, YamlNode::Kind::Map));
    }
    void OnMapEnd() override { close(); }

    [[nodiscard]] YamlNode finish() && { return std::move(m_root); }

private:
    static void refuseTag(const YAML::Mark& mark, const std::string& tag) {
        if (tag.empty() || tag == "?" || tag == "!") return;
        throw Refusal{lineOf(mark), "tags (!name) are not read: leave it out"};
    }
    YamlNode begin(const YAML::Mark& mark, YamlNode::Kind kind) {
        if (++m_nodes > MaxNodes) {
            throw Refusal{lineOf(mark), fmt::format("expected at most {} values in a file", MaxNodes)};
        }
        YamlNode node;
        node.kind = kind;
        node.line = lineOf(mark);
        return node;
    }
    void open(YamlNode node) {
        if (m_open.size() >= MaxDepth) {
            throw Refusal{node.line, fmt::format("expected at most {} levels of nesting", MaxDepth)};
        }
        m_open.push_back(std::move(node));
    }
    void close() {
        YamlNode node = std::move(m_open.back());
        m_open.pop_back();
        add(std::move(node));
    }
    void add(YamlNode node) {
        if (m_open.empty()) {
            m_root = std::move(node);
            return;
        }
        YamlNode& parent = m_open.back();
        if (parent.kind == YamlNode::Kind::Map && parent.keys.size() == parent.items.size()) {
            if (node.kind != YamlNode::Kind::Scalar) throw Refusal{node.line, "expected a word as key"};
            parent.keys.push_back(std::move(node.scalar));
            parent.keyLines.push_back(node.line);
            return;
        }
        parent.items.push_back(std::move(node));
    }

    YamlNode m_root;
    std::vector<YamlNode> m_open;
    int m_nodes = 0;
};

/// Length of the UTF-8 sequence at the start of @p text; 0 when there is none.
std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
    }
    const bool overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool surrogate = first == 0xED && byte(1) > 0x9F;
    return overlong || surrogate || (first == 0xF4 && byte(1) > 0x8F) ? 0 : length;
}

/// Refuses what is no text, which yaml-cpp takes for the end of its input or for other encodings.
void checkText(std::string_view text) {
    int line = 1;
    while (!text.empty()) {
        const char c = text.front();
        const std::size_t length = utf8Length(text);
        if (length == 0) throw Refusal{line, "expected text in UTF-8"};
        const bool control = (c >= 0 && c < ' ' && c != '\n' && c != '\r' && c != '\t') || c == '\x7f';
        if (control) {
            throw Refusal{line, fmt::format("expected text, found the control character 0x{:02x}", c)};
        }
        if (c == '\n') ++line;
        text.remove_prefix(length);
    }
}

/// A text as a stream, without a copy.
class TextBuffer final : public std::streambuf {
public:
    explicit TextBuffer(std::string_view text) {
        char* begin = const_cast<char*>(text.data());  // never written to: there is no put area
        setg(begin, begin, begin + text.size());
    }
};

}  // namespace

Result<YamlNode> parseYaml(std::string_view text, const std::string& name) {
    try {
        checkText(text);
        TextBuffer buffer(text);
        std::istream in(&buffer);
        YAML::Parser parser(in);
        TreeBuilder builder;
        parser.HandleNextDocument(builder);
        TreeBuilder second;
        if (parser.HandleNextDocument(second)) {
            return Error{name + ": expected one YAML document, found another behind it"};
        }
        return std::move(builder).finish();
    } catch (const Refusal& refusal) {
        return Error{fmt::format("{}:{}: {}", name, refusal.line, refusal.text)};
    } catch (const YAML::Exception& problem) {
        const int line = problem.mark.is_null() ? 1 : lineOf(problem.mark);
        return Error{fmt::format("{}:{}: not YAML: {}", name, line, problem.msg)};
    }
}

}  // namespace leitstand::detail
