#include "widgets/map_view/render/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>

#include "widgets/map_view/render/actors.h"
#include "widgets/map_view/render/detail_budget.h"
#include "widgets/map_view/render/egl_context.h"
#include "widgets/map_view/render/render_window.h"

namespace leitstand {
namespace {

constexpr double PointSize = 2.0;  ///< [logical px]

void addPlane(vtkPlaneCollection* planes, double height, double direction) {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(0.0, 0.0, height);
    plane->SetNormal(0.0, 0.0, direction);
    planes->AddItem(plane);
}

vtkNew<vtkPlaneCollection> clipPlanes(const MapViewSettings& settings) {
    vtkNew<vtkPlaneCollection> planes;
    if (settings.minHeight) addPlane(planes, *settings.minHeight, 1.0);
    if (settings.maxHeight) addPlane(planes, *settings.maxHeight, -1.0);
    return planes;
}

void apply(const MapCamera& camera, vtkRenderer* renderer) {
    vtkCamera* target = renderer->GetActiveCamera();
    const Eigen::Vector3d eye = camera.eye(), up = camera.up();
    target->SetFocalPoint(camera.focus.x(), camera.focus.y(), camera.focus.z());
    target->SetPosition(eye.x(), eye.y(), eye.z());
    target->SetViewUp(up.x(), up.y(), up.z());
    target->SetViewAngle(vtkMath::DegreesFromRadians(MapCamera::FieldOfView));
    target->SetParallelProjection(camera.parallel);
    target->SetParallelScale(camera.distance * std::tan(MapCamera::FieldOfView / 2));
    renderer->ResetCameraClippingRange();
}

}  // namespace

struct Scene::State {
    std::unique_ptr<EglContext> context;  // outlives all that VTK has in it
    vtkNew<RenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    std::vector<ScanActor> scans;
    VoxelActor voxels;
    SceneContentPtr content = std::make_shared<const SceneContent>();
    DetailBudget budget;
    bool fresh = true;  ///< the next pass also uploads, its time says nothing about points

    void addScans(std::size_t count);
    std::size_t shownPoints() const;
    void pass(double from, double to);
};

void Scene::State::addScans(std::size_t count) {
    while (scans.size() > count) {
        renderer->RemoveActor(scans.back().actor());
        scans.pop_back();
    }
    while (scans.size() < count) {
        scans.emplace_back();
        renderer->AddActor(scans.back().actor());
    }
}

std::size_t Scene::State::shownPoints() const {
    std::size_t sum = 0;
    for (const ScanActor& scan : scans) {
        if (scan.actor()->GetVisibility() != 0) sum += scan.shownPoints();
    }
    return sum;
}

/// Draws a share of every scan's points on top of what is there; the first pass begins anew.
void Scene::State::pass(double from, double to) {
    const bool first = from == 0.0;
    renderer->SetPreserveColorBuffer(!first);
    renderer->SetPreserveDepthBuffer(!first);
    for (ScanActor& scan : scans) scan.setRange(from, to);
    window->Render();
}

Result<std::unique_ptr<Scene>> Scene::create(const EglDisplay& display) {
    auto context = EglContext::create(display);
    if (!context) return context.error();
    auto state = std::make_unique<State>();
    state->context = std::move(context).value();
    state->window->start(*state->context);
    state->renderer->AddActor(state->voxels.actor());
    state->window->AddRenderer(state->renderer);
    state->window->OpenGLInitContext();
    if (!state->window->ready()) return Error{"OpenGL 3.2 is not available"};
    return std::unique_ptr<Scene>(new Scene(std::move(state)));
}

Scene::Scene(std::unique_ptr<State> state) : m_state(std::move(state)) {}

Scene::~Scene() {
    m_state->context->makeCurrent();
    m_state->window->Finalize();
}

void Scene::setContent(SceneContentPtr content) {
    State& state = *m_state;
    state.context->makeCurrent();
    const SceneContentPtr former = std::exchange(state.content, std::move(content));
    state.fresh = true;
    state.addScans(state.content->scans.size());
    const auto planes = clipPlanes(state.content->settings);
    for (std::size_t i = 0; i < state.scans.size(); ++i) {
        state.scans[i].update(state.content->scans[i]);
        state.scans[i].setClip(planes);
    }
    state.voxels.update(state.content->voxels);
    const Rgba background = mapColours(state.content->settings.theme).background;
    state.renderer->SetBackground(background.r / 255.0, background.g / 255.0, background.b / 255.0);
}

MapPicture Scene::draw(const DrawOrder& order, const std::function<bool()>& interrupted) {
    using Clock = std::chrono::steady_clock;
    State& state = *m_state;
    state.context->makeCurrent();
    const QSize size = (QSizeF(order.size) * order.pixelRatio).toSize().expandedTo(QSize(1, 1));
    state.window->SetSize(size.width(), size.height());
    apply(order.camera, state.renderer);
    for (ScanActor& scan : state.scans) scan.setPointSize(PointSize * order.pixelRatio);

    MapPicture picture{{}, order, state.content, false};
    const auto points = static_cast<double>(state.shownPoints());
    double done = 0.0;
    bool last = false;
    while (!last) {
        const Clock::time_point start = Clock::now();
        const double share = static_cast<double>(state.budget.points()) / std::max(points, 1.0);
        const double end = std::min(1.0, done + share);
        state.pass(done, end);
        last = end >= 1.0 || !order.full || interrupted();
        if (last) {
            picture.image = state.window->read();
        } else {
            state.window->WaitForCompletion();
        }
        const auto drawn = static_cast<std::size_t>((end - done) * points);
        if (!std::exchange(state.fresh, false)) state.budget.drawn(drawn, Clock::now() - start);
        done = end;
    }
    picture.image.setDevicePixelRatio(order.pixelRatio);
    picture.complete = done >= 1.0;
    return picture;
}

}  // namespace leitstand
