#include "tests/app/report/foreign_bag.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "tests/support/rooms.h"
#include "transport/convert/encode.h"

namespace leitstand::test {
namespace {

constexpr int Width = 32, Height = 24;  ///< of pictures [px]

/// Odometry counts from afar.
Pose roomInOdom() {
    return poseFrom({400.0, -70.0, 0.0}, 0, 0, degrees(30));
}

Pose sensorInBase() {
    return poseFrom({ForeignBag::Ahead, 0.0, ForeignBag::Up}, 0, 0, 0);
}

}  // namespace

Time ForeignBag::at(double seconds) {
    return Time(std::chrono::seconds(1'700'000'000)) + std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

Pose ForeignBag::baseInRoom(int step) {
    const double way = std::min(step, 6) * 0.2, turn = std::max(0, step - 6) * degrees(15);
    return poseFrom({-1.5 + way, 0.5, 0.0}, 0, 0, turn);
}

ForeignBag::ForeignBag(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    const auto file = folder / (folder.filename().string() + "_0.db3");
    EXPECT_EQ(sqlite3_open(file.c_str(), &m_database), SQLITE_OK);
    run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
        "serialization_format TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT "
        "NULL, "
        "data BLOB NOT NULL); CREATE INDEX timestamp_idx ON messages (timestamp ASC); BEGIN;");
}

ForeignBag::~ForeignBag() {
    run("COMMIT;");
    sqlite3_close(m_database);
}

void ForeignBag::run(const std::string& sql) {
    EXPECT_EQ(sqlite3_exec(m_database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
        << sqlite3_errmsg(m_database);
}

void ForeignBag::write(double seconds, const std::string& topic, const Sample& sample) {
    const std::string type(typeOf(sample));
    const auto payload = encode(sample, type);
    ASSERT_TRUE(payload.ok()) << payload.error().text;
    const auto [known, fresh] = m_topics.try_emplace(topic, static_cast<int>(m_topics.size()) + 1);
    if (fresh)
        run(fmt::format("INSERT INTO topics VALUES ({}, '{}', '{}', 'cdr');", known->second, topic, type));
    sqlite3_stmt* insert = nullptr;
    ASSERT_EQ(
        sqlite3_prepare_v2(m_database, "INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", -1,
                           &insert, nullptr),
        SQLITE_OK);
    sqlite3_bind_int(insert, 1, known->second);
    sqlite3_bind_int64(insert, 2, at(seconds).time_since_epoch().count());
    sqlite3_bind_blob64(insert, 3, (*payload)->data(), (*payload)->size(), SQLITE_STATIC);
    EXPECT_EQ(sqlite3_step(insert), SQLITE_DONE) << sqlite3_errmsg(m_database);
    sqlite3_finalize(insert);
}

void ForeignBag::sayCloud(int step) {
    RoomSettings room;
    room.sensorInRoom = baseInRoom(step) * sensorInBase();
    room.rows = 80;
    room.columns = 140;
    room.seed = static_cast<unsigned>(step + 1);
    CloudSample cloud;
    cloud.header = {at(step + 0.3), "lidar"};
    for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
        if (point.allFinite()) cloud.points.push_back(point);
    }
    write(step + 0.31, "/rover/points", cloud);
}

void ForeignBag::drive() {
    TransformsSample tree;
    tree.transforms.push_back({{at(0), "base_link"}, "lidar", sensorInBase()});
    write(0.0, "/rover/tf_static", tree);
    for (int step = 0; step <= Steps; ++step) {
        for (const double part : {0.0, 0.3, 0.6}) {
            OdometrySample odometry;
            odometry.header = {at(step + part), "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = roomInOdom() * baseInRoom(step);
            write(step + part, "/rover/odom", odometry);
            if (part == 0.3 && step % 2 == 0) sayCloud(step);
        }
        PictureSample picture;
        picture.header = {at(step + 0.8), "eye"};
        picture.encoding = "rgb8";
        picture.width = Width;
        picture.height = Height;
        picture.step = 3 * Width;
        const auto bytes =
            std::make_shared<std::vector<std::byte>>(3 * Width * Height, std::byte(greyOf(step)));
        picture.content = {bytes, *bytes};
        write(step + 0.8, "/rover/eye/image_raw", picture);
    }
}

}  // namespace leitstand::test
