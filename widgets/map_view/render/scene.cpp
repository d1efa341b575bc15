#include "widgets/map_view/render/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
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
#include "widgets/map_view/scene/scene_sample.h"

namespace leitstand {
namespace {

constexpr double PointSize = 2.0;  ///< [logical px]
/// One that is overtaken soon. While a robot drives there are ten a second, beside all else that a
/// station does.
constexpr DetailBudget::Seconds QuickPicture(0.02);
constexpr std::size_t Many = 40;              ///< scans; of more, a sample is drawn first
constexpr std::size_t MostSampled = 300'000;  ///< points of it

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

bool alike(const SceneScan& a, const SceneScan& b) {
    return a.visible == b.visible && a.points == b.points && a.look.colours == b.look.colours &&
           a.look.shown == b.look.shown && a.poseInMap.matrix() == b.poseInMap.matrix();
}

/// Whether @p now shows what @p before does, and scans that came after them.
bool continues(const SceneContent& before, const SceneContent& now) {
    return before.settings == now.settings && before.voxels == now.voxels &&
           before.scans.size() <= now.scans.size() &&
           std::equal(before.scans.begin(), before.scans.end(), now.scans.begin(), alike);
}

/// A complete picture, in the frame buffer until something else is drawn.
struct Whole {
    DrawOrder order;
    std::size_t scans = 0;                 ///< that are in it, the first ones
    double nearest = 0.0, farthest = 0.0;  ///< of its depths [m]
};

std::size_t pointsOf(const std::vector<ScanActor*>& scans) {
    return std::accumulate(scans.begin(), scans.end(), std::size_t{0},
                           [](std::size_t sum, const ScanActor* scan) { return sum + scan->shownPoints(); });
}

}  // namespace

struct Scene::State {
    std::unique_ptr<EglContext> context;  // outlives all that VTK has in it
    vtkNew<RenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    std::vector<ScanActor> scans;
    std::vector<ScanActor*> shown;  ///< those of the scans that are to be seen
    bool many = false;              ///< the first pass draws the sample, not the scans
    ScanActor sample;
    double sampled = 1.0;  ///< the share of every scan's points that is in the sample
    VoxelActor voxels;
    SceneContentPtr content = std::make_shared<const SceneContent>();
    /// Of the first pass, in which each scan that is drawn by itself costs something however few its points.
    DetailBudget budget{QuickPicture};
    DetailBudget refining;  ///< of a pass over some
    bool fresh = true;      ///< the next pass also uploads, its time says nothing about points
    std::optional<Whole> whole;

    using Clock = std::chrono::steady_clock;

    void addScans(std::size_t count);
    void choose();
    double begin(bool full);
    bool refine(double from, std::vector<ScanActor*>::const_iterator first,
                const std::function<bool()>& interrupted);
    bool canContinue(const DrawOrder& order);
    bool continueWhole(const std::function<bool()>& interrupted);
    void keep(const MapPicture& picture);
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

/// Which scans are to be seen, and whether the first pass draws them or a sample of them.
void Scene::State::choose() {
    shown.clear();
    for (ScanActor& scan : scans) {
        if (scan.actor()->GetVisibility() != 0) shown.push_back(&scan);
    }
    many = shown.size() > Many;
    SceneSample drawn;
    drawn.scan.visible = false;
    if (many) drawn = sampleOf(content->scans, MostSampled);
    sampled = drawn.share;
    sample.update(drawn.scan);
    for (ScanActor* scan : shown) scan->actor()->SetVisibility(!many);
}

/// Draws the share of every scan's points that can be drawn quickly, and returns it. Of many scans a sample
/// is drawn instead: all of it where the picture is to be @p full.
double Scene::State::begin(bool full) {
    const Clock::time_point start = Clock::now();
    const auto points = static_cast<double>(many ? sample.shownPoints() : pointsOf(shown));
    double share = std::min(1.0, static_cast<double>(budget.points()) / std::max(points, 1.0));
    if (many && full) share = 1.0;
    renderer->SetPreserveColorBuffer(false);
    renderer->SetPreserveDepthBuffer(false);
    sample.setRange(0.0, share);
    for (ScanActor* scan : shown) scan->setRange(0.0, share);
    window->Render();
    window->WaitForCompletion();
    if (!std::exchange(fresh, false))
        budget.drawn(static_cast<std::size_t>(share * points), Clock::now() - start);
    return share * sampled;
}

/// Draws the rest on top of what is there, of the @p first scan and those after it, some at a time; false
/// when it was interrupted.
bool Scene::State::refine(double from, std::vector<ScanActor*>::const_iterator first,
                          const std::function<bool()>& interrupted) {
    renderer->SetPreserveColorBuffer(true);
    renderer->SetPreserveDepthBuffer(true);
    for (ScanActor* scan : shown) scan->actor()->VisibilityOff();
    sample.actor()->VisibilityOff();
    const bool hasVoxels = voxels.actor()->GetVisibility() != 0;
    voxels.actor()->VisibilityOff();  // are there already
    auto next = first;
    while (next != shown.end() && !interrupted()) {
        const Clock::time_point start = Clock::now();
        std::vector<ScanActor*> some;
        double points = 0.0;
        for (; next != shown.end() && points < static_cast<double>(refining.points()); ++next) {
            some.push_back(*next);
            points += (1.0 - from) * static_cast<double>((*next)->shownPoints());
        }
        for (ScanActor* scan : some) {
            scan->setRange(from, 1.0);
            scan->actor()->VisibilityOn();
        }
        window->Render();
        window->WaitForCompletion();
        for (ScanActor* scan : some) scan->actor()->VisibilityOff();
        refining.drawn(static_cast<std::size_t>(points), Clock::now() - start);
    }
    for (ScanActor* scan : shown) scan->actor()->SetVisibility(!many);
    sample.actor()->SetVisibility(many);
    voxels.actor()->SetVisibility(hasVoxels);
    return next == shown.end();
}

/// Whether a whole picture is there, seen as @p order says, on top of which the scans that came since can be
/// drawn: their depths are among those that it can tell.
bool Scene::State::canContinue(const DrawOrder& order) {
    if (!whole || !order.full || whole->order != order) return false;
    vtkCamera* camera = renderer->GetActiveCamera();
    const double expansion = renderer->GetClippingRangeExpansion();
    renderer->SetClippingRangeExpansion(0.0);
    renderer->ResetCameraClippingRange();
    renderer->SetClippingRangeExpansion(expansion);
    const double* needed = camera->GetClippingRange();
    if (needed[0] < whole->nearest || needed[1] > whole->farthest) {
        renderer->ResetCameraClippingRange();
        return false;
    }
    camera->SetClippingRange(whole->nearest, whole->farthest);
    return true;
}

/// Draws the scans that came since the whole picture on top of it; false when it was interrupted.
bool Scene::State::continueWhole(const std::function<bool()>& interrupted) {
    const ScanActor* came = scans.data() + whole->scans;
    const auto first =
        std::find_if(shown.cbegin(), shown.cend(), [came](const ScanActor* scan) { return scan >= came; });
    return refine(0.0, first, interrupted);
}

/// Notes whether the frame buffer holds a whole picture.
void Scene::State::keep(const MapPicture& picture) {
    whole.reset();
    if (!picture.complete || !picture.order.full) return;
    const double* range = renderer->GetActiveCamera()->GetClippingRange();
    whole = {picture.order, scans.size(), range[0], range[1]};
}

Result<std::unique_ptr<Scene>> Scene::create(const EglDisplay& display) {
    auto context = EglContext::create(display);
    if (!context) return context.error();
    auto state = std::make_unique<State>();
    state->context = std::move(context).value();
    state->window->start(*state->context);
    state->renderer->AddActor(state->voxels.actor());
    state->renderer->AddActor(state->sample.actor());
    state->window->AddRenderer(state->renderer);
    state->window->OpenGLInitContext();
    if (!state->window->ready()) return Error{"OpenGL 3.2 is not available"};
    auto scene = std::unique_ptr<Scene>(new Scene(std::move(state)));
    scene->setContent(std::make_shared<const SceneContent>());  // an empty map is drawn in its colours, too
    return scene;
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
    if (!continues(*former, *state.content)) state.whole.reset();
    state.addScans(state.content->scans.size());
    const auto planes = clipPlanes(state.content->settings);
    for (std::size_t i = 0; i < state.scans.size(); ++i) {
        state.scans[i].update(state.content->scans[i]);
        state.scans[i].setClip(planes);
    }
    state.sample.setClip(planes);
    state.choose();
    state.voxels.update(state.content->voxels);
    const Rgba background = mapColours(state.content->settings.theme).background;
    state.renderer->SetBackground(background.r / 255.0, background.g / 255.0, background.b / 255.0);
}

MapPicture Scene::draw(const DrawOrder& order, const std::function<bool()>& interrupted) {
    State& state = *m_state;
    state.context->makeCurrent();
    const QSize size = (QSizeF(order.size) * order.pixelRatio).toSize().expandedTo(QSize(1, 1));
    state.window->SetSize(size.width(), size.height());
    apply(order.camera, state.renderer);
    for (ScanActor& scan : state.scans) scan.setPointSize(PointSize * order.pixelRatio);
    state.sample.setPointSize(PointSize * order.pixelRatio);

    MapPicture picture{{}, order, state.content, false};
    if (state.canContinue(order)) {
        picture.complete = state.continueWhole(interrupted);
    } else {
        const double share = state.begin(order.full);
        picture.complete =
            share >= 1.0 || (order.full && state.refine(share, state.shown.cbegin(), interrupted));
    }
    state.keep(picture);
    picture.image = state.window->read();
    picture.image.setDevicePixelRatio(order.pixelRatio);
    return picture;
}

}  // namespace leitstand
