#include "core/io/robot/yaml_document.h"

#include <sstream>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/parser.h>

namespace leitstand::detail {
namespace {

/// Looks at a document before anything is built of it; throws what YAML's parser throws.
class Guard final : public YAML::EventHandler {
public:
    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { refuseAnchor(mark, anchor); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw YAML::ParserException(mark, "expected no aliases (*name) in this file");
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  const std::string&) override {
        refuseAnchor(mark, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        descend(mark, anchor);
    }
    void OnSequenceEnd() override { --m_depth; }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        descend(mark, anchor);
    }
    void OnMapEnd() override { --m_depth; }

private:
    static void refuseAnchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
        if (anchor != 0) throw YAML::ParserException(mark, "expected no anchors (&name) in this file");
    }
    void descend(const YAML::Mark& mark, YAML::anchor_t anchor) {
        refuseAnchor(mark, anchor);
        if (++m_depth > DeepestYaml) {
            throw YAML::ParserException(mark, fmt::format("expected at most {} levels", DeepestYaml));
        }
    }
    int m_depth = 0;
};

}  // namespace

Result<YAML::Node> loadYaml(std::string_view text, const std::string& name) {
    if (text.size() > LargestYaml) {
        return Error{fmt::format("{}: expected at most {} bytes, found {}", name, LargestYaml, text.size())};
    }
    if (const auto place = text.find('\0'); place != std::string_view::npos) {
        return Error{fmt::format("{}: byte {}: expected text, found a zero", name, place)};
    }
    try {
        std::istringstream in{std::string(text)};
        YAML::Parser parser(in);
        Guard guard;
        if (!parser.HandleNextDocument(guard))
            return Error{name + ": expected a YAML document, found nothing"};
        return YAML::Load(std::string(text));
    } catch (const YAML::Exception& problem) {
        return Error{fmt::format("{}:{}: {}", name, problem.mark.line + 1, problem.msg)};
    } catch (const std::exception& problem) {
        return Error{fmt::format("{}: {}", name, problem.what())};
    }
}

}  // namespace leitstand::detail
