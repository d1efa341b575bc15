#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/offscreen_fonts.h"
#include "app/cli/console/output.h"
#include "app/cli/console/progress_line.h"
#include "app/cli/console/text_table.h"
#include "app/cli/options/load_scans.h"
#include "app/language/language.h"
#include "app/report/pdf/pdf_report.h"
#include "app/services/handin/writing/report_writer.h"
#include "app/services/interrupt.h"
#include "core/version/version.h"

namespace leitstand::cli {
namespace {

struct ReportArguments {
    std::string mission, out, language = "en";
    bool json = false, pdf = true;
};

std::string jsonOf(const ReportOutcome& outcome, const ReportArguments& arguments) {
    using Json = nlohmann::ordered_json;
    Json files = Json::array();
    for (const ReportFile& file : outcome.files) {
        files.push_back(
            {{"file", file.name}, {"bytes", file.bytes}, {"whole", file.whole}, {"check", file.check}});
    }
    return jsonText({{"name", outcome.name},
                     {"folder", arguments.out},
                     {"victims", outcome.victims},
                     {"finds", outcome.finds},
                     {"scans", outcome.scans},
                     {"explored_m2", outcome.explored},
                     {"files", files},
                     {"warnings", outcome.warnings},
                     {"seconds", outcome.seconds}});
}

std::string tableOf(const ReportOutcome& outcome) {
    std::vector<std::vector<std::string>> rows = {{"file", "bytes", "read again"}};
    for (const ReportFile& file : outcome.files)
        rows.push_back({file.name, std::to_string(file.bytes), (file.whole ? "" : "BROKEN: ") + file.check});
    return textTable(rows) +
           fmt::format("{} confirmed victims of {} finds, {} scans, {:.1f} m2 explored, {:.1f} s\n",
                       outcome.victims, outcome.finds, outcome.scans, outcome.explored, outcome.seconds);
}

/// Returns the creation time that the PDF states: SOURCE_DATE_EPOCH [s], the convention of reproducible
/// builds. The epoch, which stands for now, when that is not set or makes no sense.
Time statedTime() {
    const char* seconds = std::getenv("SOURCE_DATE_EPOCH");
    if (seconds == nullptr) return {};
    std::int64_t since = 0;
    const std::string_view text(seconds);
    const auto read = std::from_chars(text.data(), text.data() + text.size(), since);
    constexpr std::int64_t Most = 9'000'000'000;  // [s], near the limit of Time
    if (read.ec != std::errc() || read.ptr != text.data() + text.size() || since < 0 || since > Most)
        return {};
    return Time(std::chrono::seconds(since));
}

int runReport(const ReportArguments& arguments) {
    ProgressLine line;
    const InterruptGuard interrupt;
    const OffscreenFonts fonts;
    useLanguage(QString::fromStdString(arguments.language));
    ReportOptions options;
    options.version = version();
    options.created = statedTime();
    if (arguments.pdf) options.pdf = &pdfOf;
    const auto show = [&](double fraction) { line.show("report", fraction); };
    const auto outcome = writeReport(arguments.mission, arguments.out, options, {show, interrupt.token()});
    line.clear();
    if (!outcome) {
        complain(line, outcome.error().text);
        return 1;
    }
    print(arguments.json ? jsonOf(*outcome, arguments) : tableOf(*outcome));
    for (const std::string& warning : outcome->warnings) complain(line, warning);
    return outcome->whole() ? 0 : 1;
}

}  // namespace

void addReport(CLI::App& app, int& exitCode) {
    CLI::App* command =
        app.add_subcommand("report", "writes the judges' folder of a mission and reads it again");
    const auto arguments = std::make_shared<ReportArguments>();
    command
        ->add_option("MISSION", arguments->mission,
                     "Folder of the mission, or one file of it (.db3, .mcap, .bag)")
        ->required();
    command->add_option("--out", arguments->out, "Folder for GeoTIFF, lists, OctoMap, PLY, trajectories, PDF")
        ->required();
    std::vector<std::string> codes;
    for (const Language& language : languages()) codes.push_back(language.code.toStdString());
    command->add_option("--language", arguments->language, "Language of the PDF and of what is doubtful")
        ->check(CLI::IsMember(codes))
        ->capture_default_str();
    command->add_flag("!--no-pdf", arguments->pdf, "Leave the PDF out");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->final_callback([arguments, &exitCode] { exitCode = runReport(*arguments); });
}

}  // namespace leitstand::cli
