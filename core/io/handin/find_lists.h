#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/base/time.h"

namespace leitstand {

/// A row of a list of what was found.
struct ListedFind {
    std::uint32_t id = 0;
    std::string time;  ///< "HH:MM:SS"
    std::string text;  ///< name of a victim ("V1"), content of a code, what an object is
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the map [m]
    std::string robot = {};                              ///< that found it; not in victim lists
    std::string mode = {};                               ///< "T" teleoperated, "A" autonomous; likewise
    std::string type = {};                               ///< of a poi: "victim", "hazmat", "qr", "object"
};

/// A list of what was found, as the rules want it beside the map.
struct FindList {
    enum class Kind : std::uint8_t { Victims, Codes, Pois };
    Kind kind = Kind::Victims;
    std::string team, country;
    std::string date;  ///< "YYYY-MM-DD"
    std::string time;  ///< "HH:MM:SS"
    std::string mission;
    std::vector<ListedFind> finds;
};

/// How the files of a list end: "_victims.csv", "_qr.csv", "_pois.csv".
[[nodiscard]] std::string endingOf(FindList::Kind kind);

/// @p list as text: victims 1.0, qr codes 1.1, pois 1.2; lines end with LF, coordinates have millimetres.
[[nodiscard]] std::string textOf(const FindList& list);
[[nodiscard]] Result<void> writeFindList(const std::filesystem::path& file, const FindList& list);

/// Reads a list leniently: with or without quotes, CRLF, byte order mark, blanks about fields, other orders
/// of columns, capitals and missing columns of no importance. Errors name file, line and expectation.
[[nodiscard]] Result<FindList> readFindList(const std::filesystem::path& file);

}  // namespace leitstand
