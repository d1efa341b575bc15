#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/result.h"

namespace leitstand {

/// Tells an operator what came of reports that are written again and again.
class ReportTelling {
public:
    /// What is to be told of the report @p done into the folder @p out, each a message: what is missing in it
    /// that the one before did not miss, then, last, that it is written, or which of its files are broken and
    /// why.
    [[nodiscard]] std::vector<std::string> of(const Result<ReportOutcome>& done,
                                              const std::filesystem::path& out);

private:
    std::vector<std::string> m_warnings;  ///< of the report before
};

}  // namespace leitstand
