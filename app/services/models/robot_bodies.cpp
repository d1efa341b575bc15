#include "app/services/models/robot_bodies.h"

#include <chrono>
#include <exception>
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

Result<ModelBody> bodyIn(const std::string& urdf, const RobotDescription& robot,
                         const std::stop_token& cancelled) {
    auto model = readUrdf(urdf, robot.name + "/robot_description");
    if (!model) return model.error();
    const PackageFiles files = PackageFiles::of(robot);
    ModelBody body = bodyOf(std::move(model).value(), robot.baseFrame,
                            [&](const std::string& uri) -> Result<TriangleMesh> {
                                if (cancelled.stop_requested()) return Error{"cancelled"};
                                const auto file = files.find(uri);
                                if (!file) return file.error();
                                return readMesh(*file);
                            });
    if (isTooLarge(body))
        return Error{
            leitstand::fill(translate("leitstand::RobotBodies", "it reaches farther than {} m from its base"),
                            ModelBody::Farthest)};
    return body;
}

}  // namespace

RobotBodies::RobotBodies(Notify notify)
    : m_notify(std::move(notify)), m_worker([this](const std::stop_token& stop) { m_jobs.work(stop); }) {}

RobotBodies::~RobotBodies() {
    m_jobs.cancel();
}

ModelBodyPtr RobotBodies::body(const RobotDescription& robot, const LatestPtr<RobotModelSample>& model) {
    constexpr std::chrono::seconds Least{5};  // between two bodies of a robot
    if (!model) return nullptr;
    const std::lock_guard lock(m_mutex);
    Entry& entry = m_entries[robot.name];
    if (entry.sequence != model->sequence) {
        entry.sequence = model->sequence;
        // A review that jumps, or a robot that starts again, sends the same model as before.
        if (entry.wanted != model->sample.urdf) entry.wanted = model->sample.urdf;
    }
    const SteadyTime now = steadyNow();
    const bool due = entry.began == SteadyTime{} || now - entry.began >= Least;
    if (entry.atWork || entry.wanted == entry.made || !due) return entry.body;
    entry.atWork = true;
    entry.began = now;
    m_jobs.submit([this, robot](const std::stop_token& cancelled) { make(robot, cancelled); });
    return entry.body;
}

void RobotBodies::make(const RobotDescription& robot, const std::stop_token& cancelled) {
    std::string urdf, text;
    {
        const std::lock_guard lock(m_mutex);
        urdf = m_entries[robot.name].wanted;
    }
    ModelBodyPtr body;
    try {
        auto made = bodyIn(urdf, robot, cancelled);
        if (cancelled.stop_requested()) return;
        if (made) {
            text = missingText(robot, *made);
            if (!made->parts.empty()) body = std::make_shared<const ModelBody>(std::move(made).value());
        } else {
            text = leitstand::fill(translate("leitstand::RobotBodies", "{}: its model is not drawn: {}"),
                                   robot.title, made.error().text);
        }
    } catch (const std::exception& broken) {  // out of memory, or what a library throws
        text = leitstand::fill(translate("leitstand::RobotBodies", "{}: its model is not drawn: {}"),
                               robot.title, broken.what());
    }
    {
        const std::lock_guard lock(m_mutex);
        Entry& entry = m_entries[robot.name];
        entry.body = std::move(body);
        entry.made = std::move(urdf);
        entry.atWork = false;
        if (entry.said == text) return;
        entry.said = text;
    }
    if (!text.empty()) m_notify(text);
}

}  // namespace leitstand
