#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/services/handin/writing/report_writer.h"
#include "core/base/result.h"

namespace leitstand {

/// Makes messages for the operator about reports that are written repeatedly.
class ReportMessages {
public:
    /// Returns the messages about the report @p done in the folder @p out. First come its warnings that the
    /// previous report did not have. The last message says that it is written, or which of its files are
    /// broken and why. For a report that failed, returns only its error.
    [[nodiscard]] std::vector<std::string> of(const Result<ReportOutcome>& done,
                                              const std::filesystem::path& out);

private:
    std::vector<std::string> m_warnings;  ///< warnings of the previous report
};

}  // namespace leitstand
