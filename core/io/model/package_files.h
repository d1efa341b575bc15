#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Where the files of a robot's model are on this computer.
class PackageFiles {
public:
    /// @p folders: each has ROS packages as subfolders, or is a package itself.
    explicit PackageFiles(std::vector<std::filesystem::path> folders) : m_folders(std::move(folders)) {}

    /// Returns the folders that the file of @p robot names, and after them those where ROS 2 and ROS 1 look,
    /// if their variables are set: AMENT_PREFIX_PATH and ROS_PACKAGE_PATH.
    [[nodiscard]] static PackageFiles of(const RobotDescription& robot);

    /// Returns the file at @p uri: "package://NAME/PATH", "model://NAME/PATH", "file://PATH", or a path. A
    /// file outside the folders is not returned: a robot chooses the URI. The error says where it was looked
    /// for.
    [[nodiscard]] Result<std::filesystem::path> find(const std::string& uri) const;

private:
    std::vector<std::filesystem::path> m_folders;
};

}  // namespace leitstand
