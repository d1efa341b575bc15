#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// Paths of the files of a keystore, in the layout of ROS 2 (sros2).
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

/// Reads a small file. The error names the file: it is missing, unreadable or above 1 MB.
[[nodiscard]] Result<std::string> readKeyFile(const std::filesystem::path& file);
/// Writes a new file and waits until it is on the disk. Its mode is 0600 if @p secret, otherwise 0644. Error
/// when it exists.
[[nodiscard]] Result<void> writeNewFile(const std::filesystem::path& file, const std::string& text,
                                        bool secret);
/// Replaces @p file by @p text, completely or not at all; mode 0644.
[[nodiscard]] Result<void> replaceFile(const std::filesystem::path& file, const std::string& text);
/// Makes @p folder with mode 0700 if @p secret, otherwise 0755. Missing folders above it get mode 0755.
[[nodiscard]] Result<void> makeFolder(const std::filesystem::path& folder, bool secret);
/// Moves a file or folder to a path where nothing exists.
[[nodiscard]] Result<void> moveTo(const std::filesystem::path& from, const std::filesystem::path& to);
/// Returns why @p file is no safe place for a key: others may read or change it. Empty: it is safe.
[[nodiscard]] std::string accessProblem(const std::filesystem::path& file);
[[nodiscard]] std::string dateOf(Time time);  ///< "2027-01-31", in UTC

}  // namespace leitstand
