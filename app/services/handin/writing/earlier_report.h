#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"

namespace leitstand {

/// The files that earlier reports left in a folder, as its SHA256SUMS lists them before the next report is
/// written. Their names may differ from those of the next report: competition, team or mission may have been
/// renamed since.
class EarlierReport {
public:
    explicit EarlierReport(std::filesystem::path folder);

    /// Removes the earlier files that are not among @p names, the files of the new report. The names of these
    /// begin with @p name; @p victims is their list of victims. Keeps files that SHA256SUMS does not list or
    /// that differ from it, and reports of missions that began at another time. Returns what cannot be
    /// removed, each in a sentence.
    [[nodiscard]] std::vector<std::string> remove(const std::string& name,
                                                  const std::vector<std::string>& names,
                                                  const FindList& victims) const;

    /// Returns the listed files that are not among @p names and still match SHA256SUMS. A report that fails
    /// lists them again, so that the next one can remove them.
    [[nodiscard]] std::vector<std::string> untouched(const std::vector<std::string>& names) const;

private:
    std::filesystem::path m_folder;
    std::vector<Checksum> m_listed;
};

}  // namespace leitstand
