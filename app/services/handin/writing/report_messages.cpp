#include "app/services/handin/writing/report_messages.h"

#include <algorithm>

#include "core/base/words.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// Returns what is wrong with @p file, named without its folder @p out, which the message names anyway.
std::string problemOf(const ReportFile& file, const fs::path& out) {
    const std::string folder = (out / "").string();
    const std::string why = file.check.starts_with(folder) ? file.check.substr(folder.size()) : file.check;
    return why.starts_with(file.name) ? why : file.name + ": " + why;
}

}  // namespace

std::vector<std::string> ReportMessages::of(const Result<ReportOutcome>& done, const fs::path& out) {
    if (!done) return {done.error().text};
    std::vector<std::string> reported;
    for (const std::string& warning : done->warnings) {
        if (std::find(m_warnings.begin(), m_warnings.end(), warning) == m_warnings.end())
            reported.push_back(warning);
    }
    m_warnings = done->warnings;
    std::string problems;
    for (const ReportFile& file : done->files) {
        if (!file.whole) problems += (problems.empty() ? "" : "; ") + problemOf(file, out);
    }
    reported.push_back(
        done->whole()
            ? leitstand::fill(translate("leitstand::ReportText", "Report written into {}"), out.string())
            : leitstand::fill(translate("leitstand::ReportText", "The report in {} is not whole: {}"),
                              out.string(), problems));
    return reported;
}

}  // namespace leitstand
