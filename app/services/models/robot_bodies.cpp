#include "app/services/models/robot_bodies.h"

#include <utility>

#include "core/base/words.h"
#include "core/event/status_samples.h"
#include "core/io/model/mesh_file.h"
#include "core/io/model/package_files.h"
#include "core/io/model/urdf.h"

namespace leitstand {
namespace {

/// Returns what is said of meshes that are missing; empty: none are.
std::string missingText(const RobotDescription& robot, const ModelBody& body) {
    if (body.missing.empty()) return {};
    return leitstand::fill(
        translate("leitstand::RobotBodies",
                  "{}: {} meshes of its model are not on this computer, simple shapes are drawn instead "
                  "({}). Name the folder with its packages in the robot's file: packages"),
        robot.title, body.missing.size(), body.missing.front());
}

}  // namespace

RobotBodies::RobotBodies(Notify notify)
    : m_notify(std::move(notify)), m_worker([this](const std::stop_token& stop) { m_jobs.work(stop); }) {}

RobotBodies::~RobotBodies() {
    m_jobs.cancel();
}

ModelBodyPtr RobotBodies::body(const RobotDescription& robot, const LatestPtr<RobotModelSample>& model) {
    if (!model) return nullptr;
    const std::lock_guard lock(m_mutex);
    Entry& entry = m_entries[robot.name];
    if (entry.sequence == model->sequence) return entry.body;
    entry.sequence = model->sequence;
    // A review that jumps, or a robot that starts again, sends the same model as before.
    if (entry.urdf == model->sample.urdf) return entry.body;
    entry.urdf = model->sample.urdf;
    entry.made = false;
    m_jobs.submit([this, robot](const std::stop_token& cancelled) {
        if (!cancelled.stop_requested()) make(robot);
    });
    return entry.body;
}

void RobotBodies::make(const RobotDescription& robot) {
    std::string urdf;
    {
        const std::lock_guard lock(m_mutex);
        const Entry& entry = m_entries[robot.name];
        if (entry.made) return;  // the newest model was made in place of an earlier one
        urdf = entry.urdf;
    }
    auto model = readUrdf(urdf, robot.name + "/robot_description");
    ModelBodyPtr body;
    std::string text;
    if (model) {
        const PackageFiles files = PackageFiles::of(robot);
        auto made = std::make_shared<const ModelBody>(bodyOf(
            std::move(model).value(), robot.baseFrame, [&](const std::string& uri) -> Result<TriangleMesh> {
                const auto file = files.find(uri);
                if (!file) return file.error();
                return readMesh(*file);
            }));
        text = missingText(robot, *made);
        if (!made->parts.empty()) body = std::move(made);
    } else {
        text = leitstand::fill(translate("leitstand::RobotBodies", "{}: its model is not drawn: {}"),
                               robot.title, model.error().text);
    }
    {
        const std::lock_guard lock(m_mutex);
        Entry& entry = m_entries[robot.name];
        if (entry.urdf != urdf) return;  // a newer one follows
        entry.body = std::move(body);
        entry.made = true;
    }
    if (!text.empty()) m_notify(text);
}

}  // namespace leitstand
