#include "app/services/models/saved_measures.h"

#include "core/io/robot/editing/robot_edits.h"

namespace leitstand {

Result<std::string> saveMeasures(const RobotDescription& robot, const RobotMeasures& measures) {
    return editRobotFile(robot.file, [&](const std::string& text, const std::string& name) {
        return withMeasures(text, name, measures);
    });
}

}  // namespace leitstand
