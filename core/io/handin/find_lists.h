#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// A row of a list of finds.
struct ListedFind {
    std::uint32_t id = 0;
    std::string time;  ///< "HH:MM:SS"
    std::string text;  ///< name of a victim ("V1"), content of a code, kind of an object
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the map [m]
    std::string robot = {};                              ///< robot that found it; not in victim lists
    /// How the robot was driven: "T" teleoperated, "A" autonomous; not in victim lists.
    std::string mode = {};
    std::string type = {};  ///< type of a poi: "victim", "hazmat", "qr", "object"
};

/// A list of finds, as the rules require it beside the map.
struct FindList {
    enum class Kind : std::uint8_t { Victims, Codes, Pois };
    Kind kind = Kind::Victims;
    std::string team, country;
    std::string date;  ///< "YYYY-MM-DD"
    std::string time;  ///< "HH:MM:SS"
    std::string mission;
    std::vector<ListedFind> finds;
};

/// Returns how the file name of @p kind ends: "_victims.csv", "_qr.csv", "_pois.csv".
[[nodiscard]] std::string endingOf(FindList::Kind kind);

/// Returns @p list as text, in the format versions of the rules: victims 1.0, qr codes 1.1, pois 1.2. Lines
/// end in LF; coordinates have three decimals.
[[nodiscard]] std::string textOf(const FindList& list);
[[nodiscard]] Result<void> writeFindList(const std::filesystem::path& file, const FindList& list);

/// Reads a list and tolerates other ways of writing it. Fields may have quotes, blanks around them or
/// capitals. Columns may have any order, and minor ones may be missing. CRLF and a byte order mark are
/// accepted. Errors name file, line and what was expected.
[[nodiscard]] Result<FindList> readFindList(const std::filesystem::path& file);

}  // namespace leitstand
