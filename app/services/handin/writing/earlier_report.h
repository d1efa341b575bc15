#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"

namespace leitstand {

/// The files that earlier reports of a mission left in a folder. Lists them by the SHA256SUMS that is there
/// before the next report is written: competition, team or mission may have been renamed since.
class EarlierReport {
public:
    explicit EarlierReport(std::filesystem::path folder);

    /// Removes earlier files that are not among @p names, the files of the new report. Those begin with
    /// @p name, and @p victims is one of their lists. Keeps files that SHA256SUMS does not list or that
    /// differ from it, and reports of missions that began at another time. Returns what cannot be removed,
    /// each in a sentence.
    [[nodiscard]] std::vector<std::string> remove(const std::string& name,
                                                  const std::vector<std::string>& names,
                                                  const FindList& victims) const;

    /// Returns the files that are not among @p names and are as SHA256SUMS lists them. A report that fails
    /// lists them again, for the next one.
    [[nodiscard]] std::vector<std::string> untouched(const std::vector<std::string>& names) const;

private:
    std::filesystem::path m_folder;
    std::vector<Checksum> m_listed;
};

}  // namespace leitstand
