#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

struct Event;
struct FrameTransform;

/// A frame of a robot's tf tree.
struct FrameNode {
    std::string frame, parent;
    std::string topic;   ///< where its newest transform came
    bool fixed = false;  ///< whether it came as a static transform, which never gets old
    Time received{};     ///< when its newest transform was received, station's clock
    double rate = 0.0;   ///< transforms per second, over the last ones; 0: fixed, or only one came
    Pose frameInParent = Pose::Identity();
    /// Other parents that the frame was given: when last, and whether by a static transform.
    struct Other {
        Time received{};
        bool fixed = false;
    };
    std::map<std::string, Other> others;
};

/// A row of a tree: a frame below its parent.
struct FrameRow {
    FrameNode node;  ///< of a root only the name counts
    bool root = false;
    int depth = 0;  ///< number of frames above it
    /// Another parent that the frame has, too: of a static transform, or given within the last seconds.
    /// Empty: none. tf cannot use both.
    std::string otherParent;
    bool circle = false;  ///< whether it is above itself, so that nothing connects it with other frames
};

/// The tf trees of one robot, from its transforms.
class FrameTree {
public:
    /// Frames that are kept. A further one takes the place of the one that was silent longest, if no static
    /// transform tells that one.
    static constexpr std::size_t MostFrames = 2'000;
    static constexpr std::size_t LongestName = 256;  ///< longer ones are not kept [B]

    /// Takes transforms; ignores other events.
    void take(const Event& event);
    /// Returns all frames, each below its parent, by name among those with one parent.
    [[nodiscard]] std::vector<FrameRow> rows(Time now) const;
    /// Whether transforms lead from @p frame to @p other, up or down.
    [[nodiscard]] bool connects(const std::string& frame, const std::string& other) const;

private:
    void take(const FrameTransform& one, const Event& event);
    [[nodiscard]] bool makeRoom();
    [[nodiscard]] std::string rootOf(const std::string& frame) const;
    std::map<std::string, FrameNode> m_nodes;  ///< by frame
};

}  // namespace leitstand
