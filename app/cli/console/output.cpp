#include "app/cli/console/output.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "core/base/printable.h"

namespace leitstand::cli {

void print(std::string_view text) {
    const std::string shown = printableLines(text);
    std::fwrite(shown.data(), 1, shown.size(), stdout);
}

void printError(std::string_view text) {
    const std::string shown = fmt::format("leitstandctl: {}\n", printable(text));
    std::fwrite(shown.data(), 1, shown.size(), stderr);
}

std::string jsonText(const nlohmann::ordered_json& json) {
    return printableJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + '\n';
}

void printJson(const nlohmann::ordered_json& json) {
    const std::string text = jsonText(json);
    std::fwrite(text.data(), 1, text.size(), stdout);
}

}  // namespace leitstand::cli
