#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <QString>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"
#include "core/mission/markers/marker_board.h"
#include "core/mission/state/robot_state.h"

namespace leitstand {

struct RobotDescription;
struct RobotInMap;

/// What a robot draws, as lines, dots and texts in the map's frame [m].
struct Drawings {
    /// Of lines and dots in all, and of texts; more are left out.
    static constexpr std::size_t MostPlaces = 20'000, MostTexts = 200;

    struct Line {
        std::vector<Eigen::Vector3d> places;
        MarkerColour colour;
    };
    struct Text {
        Eigen::Vector3d place;
        QString text;
        MarkerColour colour;
    };
    std::vector<Line> lines;
    std::vector<Line> dots;
    std::vector<Text> texts;
};

/// Keeps what one robot draws as it lies in the map.
class RobotDrawer {
public:
    /// Returns what is drawn at @p now (station's clock); null: nothing. Left out are markers in a frame that
    /// is not the robot's base, a sensor's whose place is in the robot's file, its odometry's or one above.
    /// The same pointer comes again as long as nothing moves by a centimetre.
    [[nodiscard]] std::shared_ptr<const Drawings> at(const RobotDescription& robot,
                                                     const RobotState& reported, const RobotInMap& place,
                                                     Time now);

private:
    /// Where a frame lies; empty: nobody tells.
    struct Placed {
        std::optional<Pose> inMap, inBase;  ///< one of them at most
    };
    using Frames = std::map<std::string, Placed>;

    [[nodiscard]] bool sameFrames(const Frames& frames) const;

    std::vector<LatestPtr<MarkerBoard>> m_boards;
    Frames m_frames;  ///< of the markers
    Pose m_baseInMap = Pose::Identity(), m_odomInMap = Pose::Identity();
    bool m_locked = false;  ///< whether a marker moves along with the robot
    /// When it was drafted, and when the next marker is over.
    std::optional<Time> m_drafted, m_next;
    std::shared_ptr<const Drawings> m_drawings;
};

}  // namespace leitstand
