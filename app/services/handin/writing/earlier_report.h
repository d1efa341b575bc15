#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"

namespace leitstand {

/// The files from earlier reports in a folder, as its SHA256SUMS lists them before the next report is
/// written. Their names may differ from those of the next report, because competition, team or mission may
/// have been renamed.
class EarlierReport {
public:
    explicit EarlierReport(std::filesystem::path folder);

    /// Removes the earlier files that are not among @p names, the files of the new report. The names of the
    /// new files begin with @p name; @p victims is their list of victims. Keeps files that SHA256SUMS does
    /// not list or that differ from it, and reports of missions that began at another time. Returns a
    /// sentence for each file that cannot be removed.
    [[nodiscard]] std::vector<std::string> remove(const std::string& name,
                                                  const std::vector<std::string>& names,
                                                  const FindList& victims) const;

    /// Returns the listed files that are not among @p names and still match SHA256SUMS. If the new report
    /// fails, it lists them again, so that the next report can remove them.
    [[nodiscard]] std::vector<std::string> untouched(const std::vector<std::string>& names) const;

private:
    std::filesystem::path m_folder;
    std::vector<Checksum> m_listed;
};

}  // namespace leitstand
