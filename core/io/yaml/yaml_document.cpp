#include "core/io/yaml/yaml_document.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/parser.h>

#include "core/base/words.h"
#include "core/io/yaml/yaml_errors.h"

namespace leitstand::detail {
namespace {

/// Valid YAML that this program does not accept.
struct Refused : std::runtime_error {
    Refused(const YAML::Mark& mark, const std::string& text)
        : std::runtime_error(text), line(mark.line + 1) {}
    int line;
};

/// Checks a document before anything is built from it.
class Guard final : public YAML::EventHandler {
public:
    void OnDocumentStart(const YAML::Mark& mark) override {
        if (++m_documents > 1)
            throw Refused(mark,
                          translate("leitstand::Error", "expected one YAML document, found a second one"));
    }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { refuse(mark, "", anchor); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw Refused(mark, translate("leitstand::Error", "expected no alias, found one (*name)"));
    }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  const std::string&) override {
        refuse(mark, tag, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        descend(mark, tag, anchor);
    }
    void OnSequenceEnd() override { --m_depth; }
    void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        descend(mark, tag, anchor);
    }
    void OnMapEnd() override { --m_depth; }

private:
    static void refuse(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        if (anchor != 0)
            throw Refused(mark, translate("leitstand::Error", "expected no anchor, found one (&name)"));
        // "?" and "!" mark plain and quoted texts without a tag.
        if (!tag.empty() && tag != "?" && tag != "!")
            throw Refused(mark, leitstand::fill(translate("leitstand::Error", "expected no tag, found {}"),
                                                shown(tag)));
    }
    void descend(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor) {
        refuse(mark, tag, anchor);
        if (++m_depth > DeepestYaml)
            throw Refused(
                mark, leitstand::fill(translate("leitstand::Error", "expected at most {} levels, found more"),
                                      DeepestYaml));
    }
    int m_depth = 0, m_documents = 0;
};

/// Returns the length of the UTF-8 character at the beginning of @p text [bytes]; 0 when there is none.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned first = byte(0);
    const std::size_t length = first < 0x80                    ? 1
                               : first >= 0xC2 && first < 0xE0 ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    }
    const bool tooLong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
    const bool noCharacter = (first == 0xED && byte(1) > 0x9F) || (first == 0xF4 && byte(1) > 0x8F);
    return tooLong || noCharacter ? 0 : length;
}

/// Adds an error for bytes that are no text and for indentation by tabs. YAML forbids such tabs, and its
/// readers disagree on their meaning.
void checkText(std::string_view text, YamlErrors& errors) {
    int line = 1;
    bool indentation = true, tab = false;
    for (std::size_t i = 0; i < text.size();) {
        const char c = text[i];
        const auto code = static_cast<unsigned char>(c);
        const std::size_t length = characterLength(text.substr(i));
        if (length == 0 || (code < 0x20 && c != '\t' && c != '\n' && c != '\r') || code == 0x7F)
            return errors.add(
                line, {},
                leitstand::fill(translate("leitstand::Error", "expected UTF-8 text, found byte 0x{:02x}"),
                                code));
        if (c == '\n') {
            ++line;
            indentation = true;
            tab = false;
        } else if (indentation && c == '\t') {
            tab = true;
        } else if (indentation && c != ' ' && c != '\r') {
            if (tab && c != '#')
                errors.add(
                    line, {},
                    translate("leitstand::Error", "expected spaces before the first word, found a tab"));
            indentation = false;
        }
        i += length;
    }
}

}  // namespace

Result<YAML::Node> loadYaml(std::string_view text, const std::string& name) {
    if (text.size() > LargestYaml) {
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected at most {} bytes, found more"), name, LargestYaml)};
    }
    YamlErrors errors(name);
    checkText(text, errors);
    if (!errors.empty()) return errors.error();
    try {
        std::istringstream in{std::string(text)};
        YAML::Parser parser(in);
        Guard guard;
        if (!parser.HandleNextDocument(guard)) {
            errors.add(1, {},
                       leitstand::fill(translate("leitstand::Error", "expected keys and values, found {}"),
                                       translate("leitstand::Error", "nothing")));
            return errors.error();
        }
        while (parser.HandleNextDocument(guard)) {  // throws at the second one
        }
        return YAML::Load(std::string(text));
    } catch (const Refused& problem) {
        errors.add(problem.line, {}, problem.what());
    } catch (const YAML::Exception& problem) {
        errors.add(std::max(0, problem.mark.line) + 1, {},
                   leitstand::fill(translate("leitstand::Error", "expected YAML, found a mistake: {}"),
                                   problem.msg));
    } catch (const std::exception& problem) {
        errors.add(1, {},
                   leitstand::fill(translate("leitstand::Error", "expected YAML, found a mistake: {}"),
                                   problem.what()));
    }
    return errors.error();
}

}  // namespace leitstand::detail
