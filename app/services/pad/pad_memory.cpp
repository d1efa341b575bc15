#include "app/services/pad/pad_memory.h"

#include <cctype>
#include <system_error>
#include <utility>

#include "core/io/pad/pad_file.h"

namespace leitstand {

PadMemory::PadMemory(std::filesystem::path folder) : m_folder(std::move(folder)) {}

std::filesystem::path PadMemory::fileOf(const std::string& guid) const {
    std::string name;
    for (const char c : guid) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
    }
    if (name.empty()) name = "unknown";
    return m_folder / (name + ".yaml");
}

PadBindings PadMemory::bindings(const std::string& guid, PadLayout layout, std::string& warning) const {
    warning.clear();
    const std::filesystem::path file = fileOf(guid);
    std::error_code error;
    if (m_folder.empty() || !std::filesystem::exists(file, error)) return defaultBindings(layout);
    auto kept = readPad(file);
    if (!kept) {
        warning = kept.error().text;
        return defaultBindings(layout);
    }
    // Numbers of the other layout mean other controls.
    if (kept->layout != layout) return defaultBindings(layout);
    return std::move(kept).value();
}

Result<void> PadMemory::keep(const std::string& guid, const std::string& name,
                             const PadBindings& bindings) const {
    return m_folder.empty() ? Result<void>() : writePad(bindings, name, fileOf(guid));
}

}  // namespace leitstand
