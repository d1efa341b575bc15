#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/control/grants.h"

namespace leitstand {

/// Returns a new identity of 122 random bits: "3f2b8c1e-0d4a-4b6e-9a51-7c0f3d2e8b19" (RFC 4122, version 4).
[[nodiscard]] std::string newStationId();

/// Parses the @p text of a station's file; empty when it is invalid.
[[nodiscard]] std::optional<StationIdentity> parseStation(const std::string& text);

/// The identity of a station and the grants that it held, kept in a file (YAML) between runs. The file is
/// made when it is missing. While this object lives, no other program can use the identity: two programs of
/// one identity would both hold its grants.
class StationFile {
public:
    /// Opens or makes @p file. Error, with the name of the file, when it cannot be written or another program
    /// has it. An invalid file is moved aside ("<file>.damaged") and a new identity made: see warning().
    [[nodiscard]] static Result<StationFile> open(const std::filesystem::path& file,
                                                  const std::string& title);

    [[nodiscard]] const StationIdentity& identity() const { return m_identity; }  ///< as it was at the start
    [[nodiscard]] const std::string& warning() const {
        return m_warning;
    }  ///< for people; empty when all is well
    /// Replaces the stored grants by @p held; the file is never half written.
    Result<void> remember(const std::vector<HeldGrant>& held) const;

private:
    struct Lock;
    StationFile() = default;

    std::filesystem::path m_file;
    StationIdentity m_identity;
    std::string m_warning;
    std::shared_ptr<const Lock> m_lock;
};

}  // namespace leitstand
