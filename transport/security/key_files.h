#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// Where the files of a keystore stand: the layout of ROS 2 (sros2).
struct KeystoreLayout {
    std::filesystem::path folder;

    [[nodiscard]] std::filesystem::path identityCa() const { return folder / "public/identity_ca.cert.pem"; }
    [[nodiscard]] std::filesystem::path identityCaKey() const {
        return folder / "private/identity_ca.key.pem";
    }
    [[nodiscard]] std::filesystem::path permissionsCa() const {
        return folder / "public/permissions_ca.cert.pem";
    }
    [[nodiscard]] std::filesystem::path permissionsCaKey() const {
        return folder / "private/permissions_ca.key.pem";
    }
    [[nodiscard]] std::filesystem::path enclaves() const { return folder / "enclaves"; }
    [[nodiscard]] std::filesystem::path enclave(const std::string& name) const { return enclaves() / name; }
    [[nodiscard]] std::filesystem::path retired() const { return folder / "retired"; }
};

/// Reads a small file; an error that names it when it is absent, unreadable or above 1 MB.
[[nodiscard]] Result<std::string> readKeyFile(const std::filesystem::path& file);
/// Writes a file that is not there yet, with mode 0600 when @p secret, else 0644, down to the disk.
[[nodiscard]] Result<void> writeNewFile(const std::filesystem::path& file, const std::string& text,
                                        bool secret);
/// Puts @p text in @p file's place, whole or not at all; mode 0644.
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& file, const std::string& text);
/// Makes @p folder and those above it where they are missing; mode 0700 when @p secret.
[[nodiscard]] Result<void> makeFolder(const std::filesystem::path& folder, bool secret);
/// Moves a file or folder to a place that is not taken.
[[nodiscard]] Result<void> moveTo(const std::filesystem::path& from, const std::filesystem::path& to);
/// Why @p file is no safe place for a key: others may read it. Empty when all is well.
[[nodiscard]] std::string accessProblem(const std::filesystem::path& file);
[[nodiscard]] std::string dateOf(Time time);  ///< "2027-01-31", UTC

}  // namespace leitstand
