#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/sample.h"

struct sqlite3;

namespace leitstand::test {

/// A bag as ROS's own recorder leaves it, of a robot that nobody described: a room of 8 m x 6 m with a
/// scanner that sits before the base, as tf_static tells, odometry that counts from afar, and a camera.
class ForeignBag {
public:
    static constexpr double Ahead = 0.4, Up = 0.5;  ///< of the base: where the scanner sits [m]
    static constexpr int Steps =
        12;  ///< of a drive, a second each: 1.2 m ahead, then a right angle on the spot

    explicit ForeignBag(const std::filesystem::path& folder);
    ~ForeignBag();
    ForeignBag(const ForeignBag&) = delete;
    ForeignBag& operator=(const ForeignBag&) = delete;

    void write(double seconds, const std::string& topic, const Sample& sample);
    /// Clouds at 0.31 s of every second step, pictures at 0.8 s of every step as bright as greyOf() tells.
    void drive();
    void sayCloud(int step);  ///< on "/rover/points"

    [[nodiscard]] static Time at(double seconds);
    [[nodiscard]] static Pose baseInRoom(int step);  ///< after so many of Steps
    [[nodiscard]] static int greyOf(int step) { return 40 + 10 * step; }

private:
    void run(const std::string& sql);

    sqlite3* m_database = nullptr;
    std::map<std::string, int> m_topics;  ///< their numbers
};

}  // namespace leitstand::test
