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

/// The identity of a station and the grants that it held, in a file (YAML) that is kept between runs. The
/// file is made when it is missing. While this object exists, no other program can use the identity.
/// Otherwise two programs with one identity would both hold its grants.
class StationFile {
public:
    /// Opens or makes @p file. An error names the file: it cannot be written, or another program uses it. An
    /// invalid file is moved aside ("<file>.damaged") and a new identity is made: see warning().
    [[nodiscard]] static Result<StationFile> open(const std::filesystem::path& file,
                                                  const std::string& title);

    /// Identity as it was at the start.
    [[nodiscard]] const StationIdentity& identity() const { return m_identity; }
    [[nodiscard]] const std::string& warning() const {
        return m_warning;
    }  ///< text for people; empty when there is nothing to warn about
    /// Replaces the stored grants by @p held, completely or not at all.
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
