#include "app/services/layouts/layout_book.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/words.h"
#include "core/io/settings/folders.h"
#include "core/io/settings/layout_file.h"

namespace leitstand {
namespace fs = std::filesystem;
namespace {

constexpr std::array Shipped = {"drive", "explore", "map",    "review",
                                "link",  "report",  "compare"};  ///< in the order of their keys

bool isName(const std::string& name) {
    return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
    });
}

fs::path fileOf(const fs::path& folder, const std::string& name) {
    return folder / (name + ".yaml");
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    std::error_code problem;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const fs::path& file = entry->path();
        if (file.extension() == ".yaml" && isName(file.stem().string())) names.insert(file.stem().string());
    }
    return names;
}

}  // namespace

LayoutBook::LayoutBook() : LayoutBook(userFolder("layouts"), shippedFolder("layouts")) {}

LayoutBook::LayoutBook(fs::path own, fs::path shipped)
    : m_own(std::move(own)), m_shipped(std::move(shipped)) {}

bool LayoutBook::isOwn(const std::string& name) const {
    std::error_code problem;
    return !m_own.empty() && isName(name) && fs::exists(fileOf(m_own, name), problem);
}

std::vector<WindowLayout> LayoutBook::all(std::vector<std::string>& errors) const {
    std::vector<std::string> names(Shipped.begin(), Shipped.end());
    for (const std::string& name : namesIn(m_own)) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::vector<WindowLayout> layouts;
    for (const std::string& name : names) {
        auto layout = find(name);
        if (!layout) {
            errors.push_back(layout.error().text);
            // A damaged file of the user does not remove the program's layout.
            layout = readLayout(fileOf(m_shipped, name));
        }
        if (layout) layouts.push_back(std::move(layout).value());
    }
    return layouts;
}

Result<WindowLayout> LayoutBook::find(const std::string& name) const {
    std::error_code problem;
    if (isOwn(name)) return readLayout(fileOf(m_own, name));
    if (isName(name) && fs::exists(fileOf(m_shipped, name), problem))
        return readLayout(fileOf(m_shipped, name));
    std::set<std::string> names = namesIn(m_own);
    names.merge(namesIn(m_shipped));
    return Error{leitstand::fill(translate("leitstand::Error", "{}: expected the name of a layout ({})"),
                                 name, fmt::format("{}", fmt::join(names, ", ")))};
}

Result<void> LayoutBook::save(const WindowLayout& layout) const {
    if (!isName(layout.name))
        return Error{leitstand::fill(
            translate("leitstand::Error", "\"{}\": expected a name of letters, digits, _ and -"),
            layout.name)};
    std::error_code problem;
    fs::create_directories(m_own, problem);
    return saveLayout(layout, fileOf(m_own, layout.name));
}

Result<void> LayoutBook::remove(const std::string& name) const {
    if (!isOwn(name))
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: expected a layout of one's own"), name)};
    std::error_code problem;
    fs::remove(fileOf(m_own, name), problem);
    if (problem) return Error{fmt::format("{}: {}", fileOf(m_own, name).string(), problem.message())};
    return {};
}

}  // namespace leitstand
