#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/robot/control/grants.h"

namespace leitstand {

/// A new identity, 122 random bits: "3f2b8c1e-0d4a-4b6e-9a51-7c0f3d2e8b19" (RFC 4122, version 4).
[[nodiscard]] std::string newStationId();

/// What the @p text of a station's file says; nothing when it makes no sense.
[[nodiscard]] std::optional<StationIdentity> parseStation(const std::string& text);

/// Who a station is, kept in a file (YAML) from run to run, with the grants that it held: made when it is
/// not there. As long as this object lives, the identity is its own: two programs of one identity would both
/// hold its grants.
class StationFile {
public:
    /// Errors name the file: it cannot be written, or another program has it. One that cannot be understood
    /// is set aside ("<file>.damaged"), and a new identity made: see warning().
    [[nodiscard]] static Result<StationFile> open(const std::filesystem::path& file,
                                                  const std::string& title);

    [[nodiscard]] const StationIdentity& identity() const { return m_identity; }  ///< as it was at the start
    [[nodiscard]] const std::string& warning() const {
        return m_warning;
    }  ///< for people; empty when all is well
    /// Keeps @p held instead of what was; the file is never half written.
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
