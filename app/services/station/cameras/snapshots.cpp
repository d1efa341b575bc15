#include "app/services/station/cameras/snapshots.h"

#include <ctime>
#include <future>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/coding/picture_png.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// "2026-11-21_17-05-03.250", UTC.
std::string stampText(Time time) {
    const auto since = time.time_since_epoch();
    const auto seconds = std::chrono::floor<std::chrono::seconds>(since);
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(since - seconds);
    const auto whole = static_cast<std::time_t>(seconds.count());
    std::tm parts{};
    ::gmtime_r(&whole, &parts);
    return fmt::format("{:04}-{:02}-{:02}_{:02}-{:02}-{:02}.{:03}", parts.tm_year + 1900, parts.tm_mon + 1,
                       parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec, milliseconds.count());
}

std::string poseText(const Pose& pose) {
    const Eigen::Vector3d at = pose.translation();
    const Eigen::Quaterniond q(pose.linear());
    return fmt::format("{:.4f} {:.4f} {:.4f} {:.6f} {:.6f} {:.6f} {:.6f}", at.x(), at.y(), at.z(), q.x(),
                       q.y(), q.z(), q.w());
}

PictureTexts textsOf(const SnapshotRequest& request) {
    const ShownPicture& picture = *request.picture;
    PictureTexts texts = {{"Software", "Leitstand"},
                          {"Title", picture.robot + ": " + request.camera},
                          {"Robot", picture.robot},
                          {"Camera", picture.sensor},
                          {"Stamp of the robot's clock [UTC]", stampText(picture.stamp)},
                          {"Received, station's clock [UTC]", stampText(picture.received)}};
    if (request.baseInOdom)
        texts.emplace_back("Pose in odom [x y z qx qy qz qw, m]", poseText(*request.baseInOdom));
    if (request.turned) {
        texts.emplace_back(
            "Camera turned [degrees left, degrees down]",
            fmt::format("{:.1f} {:.1f}", inDegrees(request.turned->pan), inDegrees(request.turned->tilt)));
    }
    if (std::holds_alternative<ThermalPicture>(picture.content))
        texts.emplace_back("Values", "as the camera sent them; docs/robots.md: thermal");
    return texts;
}

}  // namespace

Snapshots::Snapshots(fs::path mission, Listener listener)
    : m_mission(std::move(mission)),
      m_listener(std::move(listener)),
      m_thread([this](const std::stop_token& stop) { m_queue.work(stop); }) {}

void Snapshots::finish() {
    std::promise<void> written;
    m_queue.submit([&written](const std::stop_token&) { written.set_value(); }, false);
    written.get_future().wait();
}

void Snapshots::take(const SnapshotRequest& request) {
    if (!request.picture) return;
    m_queue.submit(
        [this, request](const std::stop_token&) {
            const auto file = write(request);
            if (!file && m_listener.onProblem) m_listener.onProblem(file.error().text);
            if (file && m_listener.onWritten) m_listener.onWritten(request.picture->robot, *file);
        },
        false);
}

Result<fs::path> Snapshots::write(const SnapshotRequest& request) const {
    const auto raw = decodePicture(request.picture->sample);
    if (!raw) return raw.error();
    const auto bytes = encodePng(*raw, textsOf(request));
    if (!bytes) return bytes.error();
    const fs::path folder = m_mission / "snapshots";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: the folder could not be made: {}"),
                                     folder.string(), error.message())};
    const std::string name = fmt::format("{}_{}_{}", request.picture->robot, request.picture->sensor,
                                         stampText(request.picture->received));
    fs::path file = folder / (name + ".png");
    for (int i = 2; fs::exists(file, error); ++i) file = folder / fmt::format("{}_{}.png", name, i);
    const std::string_view content(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    if (auto done = detail::writeWhole(file, content); !done) return done.error();
    return "snapshots" / file.filename();
}

}  // namespace leitstand
