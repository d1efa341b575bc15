#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"

namespace leitstand {

/// The files that earlier reports of a mission left in a folder, by the SHA256SUMS that is there before the
/// next one is written: competition, team or mission may have got other names since.
class EarlierReport {
public:
    explicit EarlierReport(std::filesystem::path folder);

    /// Removes those that are not among @p names, the files of the new report, which begin with @p name and
    /// of which @p victims is a list. Stays: what SHA256SUMS does not list, what is not as it lists it any
    /// more, reports of missions that began at another time. Returns what cannot be removed, each in a
    /// sentence.
    [[nodiscard]] std::vector<std::string> remove(const std::string& name,
                                                  const std::vector<std::string>& names,
                                                  const FindList& victims) const;

    /// Those that are not among @p names and are as SHA256SUMS lists them: a report that fails lists them on,
    /// for the next one.
    [[nodiscard]] std::vector<std::string> untouched(const std::vector<std::string>& names) const;

private:
    std::filesystem::path m_folder;
    std::vector<Checksum> m_listed;
};

}  // namespace leitstand
