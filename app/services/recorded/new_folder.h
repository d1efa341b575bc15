#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

namespace leitstand {

/// Guards the writing of a folder that was missing or empty. Unless keep() is called, removes everything that
/// was written to it, and the folder if it was missing.
class NewFolder {
public:
    explicit NewFolder(std::filesystem::path folder) : m_folder(std::move(folder)) {
        std::error_code none;
        m_wasThere = std::filesystem::exists(m_folder, none);
    }
    ~NewFolder() {
        std::error_code ignored;
        if (m_kept) return;
        if (!m_wasThere) {
            std::filesystem::remove_all(m_folder, ignored);
            return;
        }
        for (const auto& entry : std::filesystem::directory_iterator(m_folder, ignored))
            std::filesystem::remove_all(entry.path(), ignored);
    }
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    void keep() { m_kept = true; }  ///< call when the folder is complete

private:
    std::filesystem::path m_folder;
    bool m_wasThere = false, m_kept = false;
};

}  // namespace leitstand
