#include "app/services/handin/writing/earlier_report.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "core/base/words.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// Whether @p name is that of a file in its folder, not above or below it, and not hidden.
bool isPlain(const std::string& name) {
    return !name.empty() && name.front() != '.' && fs::path(name).filename() == fs::path(name);
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether @p one is as it was written.
bool isUntouched(const fs::path& folder, const Checksum& one) {
    std::error_code ignored;
    if (fs::symlink_status(folder / one.name, ignored).type() != fs::file_type::regular) return false;
    const auto sum = sha256Of(folder / one.name);
    return sum && *sum == one.sum;
}

bool isOfMission(const fs::path& list, const FindList& victims) {
    const auto read = readFindList(list);
    return read && read->date == victims.date && read->time == victims.time;
}

}  // namespace

EarlierReport::EarlierReport(fs::path folder) : m_folder(std::move(folder)) {
    // Without one, or with one that others wrote in their format, no file is known to be ours.
    if (auto listed = readChecksums(m_folder)) m_listed = std::move(listed).value();
    std::erase_if(m_listed, [](const Checksum& one) { return !isPlain(one.name); });
}

std::vector<std::string> EarlierReport::untouched(const std::vector<std::string>& names) const {
    std::vector<std::string> left;
    for (const Checksum& one : m_listed) {
        if (!contains(names, one.name) && isUntouched(m_folder, one)) left.push_back(one.name);
    }
    return left;
}

std::vector<std::string> EarlierReport::remove(const std::string& name, const std::vector<std::string>& names,
                                               const FindList& victims) const {
    // The beginning of each report's file names, and whether the report is of this mission.
    std::map<std::string, bool> reports = {{name, true}};
    const std::string ending = endingOf(FindList::Kind::Victims);
    for (const Checksum& one : m_listed) {
        if (!one.name.ends_with(ending) || contains(names, one.name)) continue;
        reports.emplace(one.name.substr(0, one.name.size() - ending.size()),
                        isOfMission(m_folder / one.name, victims));
    }
    const auto isOurs = [&](const std::string& file) {
        std::size_t longest = 0;
        bool ours = false;
        for (const auto& [beginning, mine] : reports) {
            const bool fits = file.size() > beginning.size() && file.starts_with(beginning) &&
                              (file[beginning.size()] == '.' || file[beginning.size()] == '_');
            if (!fits || beginning.size() < longest) continue;
            longest = beginning.size();
            ours = mine;
        }
        return ours;
    };
    std::vector<std::string> problems;
    for (const Checksum& one : m_listed) {
        if (contains(names, one.name) || !isOurs(one.name) || !isUntouched(m_folder, one)) continue;
        std::error_code problem;
        fs::remove(m_folder / one.name, problem);
        if (problem)
            problems.push_back(leitstand::fill(
                translate("leitstand::ReportText", "{} of an earlier report cannot be removed: {}"), one.name,
                problem.message()));
    }
    return problems;
}

}  // namespace leitstand
