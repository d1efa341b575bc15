#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/event/find_sample.h"
#include "core/io/bag/bag_writer.h"
#include "core/mission/state/fold.h"
#include "core/robot/robot_description.h"

namespace leitstand::test {

/// Writes a mission of Kurt3D at times of the test's own, with checkpoints, as a station does.
class WrittenMission {
public:
    /// @p checkpoints: every so many seconds; 0: none.
    explicit WrittenMission(std::filesystem::path folder, double checkpoints = 10.0);
    ~WrittenMission();

    /// @p seconds: after begin(). Times must not fall.
    void publish(double seconds, const std::string& topic, const Sample& sample);
    /// The robot at x = @p x [m], looking ahead, and a slice of its scanner.
    void sayPlace(double seconds, double x);
    void sayOdometry(double seconds, double x);  ///< the robot only
    /// A picture of the left camera, all of it as bright as @p grey.
    void sayPicture(double seconds, int grey);
    /// Key scan @p id of a small cloud, taken at x = @p x, matched to the one before.
    void sayKeyScan(double seconds, std::uint64_t id, double x);
    /// Scan @p id is now at x = @p x.
    void moveKeyScan(double seconds, std::uint64_t id, double x);
    /// What event @p sequence did is taken back.
    void sayUndo(double seconds, std::uint64_t sequence);
    /// How the left camera is calibrated: 320 x 240 pixels (pictures are made smaller), 53 degrees wide.
    void sayCamera(double seconds);
    void sayVictim(double seconds, std::uint32_t number, FindSample::Status status);
    /// Ends the session; the next thing that is said begins another.
    void close();

    /// Of what was said last; checkpoints count too.
    [[nodiscard]] std::uint64_t sequence() const { return m_sequence; }
    [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }
    [[nodiscard]] static Time begin();
    [[nodiscard]] static Time at(double seconds);
    [[nodiscard]] static const RobotDescription& robot();

private:
    void write(double seconds, const std::string& topic, const Sample& sample);

    std::filesystem::path m_folder;
    double m_interval;
    std::unique_ptr<BagWriter> m_writer;
    std::uint64_t m_sequence = 0;
    Fold m_fold;
    double m_checkpointed = 0.0;
};

/// A minute of it: drives 0.1 m/s ahead, turns at 30 s into mode "explore"; pictures every half second that
/// grow brighter; key scans every 5 s, of which the last moves the third; a victim filed at 20 s and
/// confirmed at 45 s; an alarm from 25 s to 28 s; a note at 40 s; a bump at 50 s.
void writeMinute(WrittenMission& mission);

}  // namespace leitstand::test
