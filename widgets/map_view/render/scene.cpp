#include "widgets/map_view/render/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
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
#include "widgets/map_view/scene/points/drawn_points.h"
#include "widgets/map_view/scene/scene_sample.h"

namespace leitstand {
namespace {

constexpr double PointSize = 2.0;  ///< [logical px]
/// Drawing time of a picture that is replaced soon. While a robot drives there are ten per second.
constexpr DetailBudget::Seconds QuickPicture(0.02);
constexpr std::size_t Many = 40;              ///< scans; with more, a sample is drawn first
constexpr std::size_t MostSampled = 300'000;  ///< points of that sample
/// Most points of many scans that OpenGL holds besides the sample. With software rendering, a whole hour's
/// map would take 300 MB.
constexpr std::size_t MostAtOnce = 500'000;

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
    return a.visible == b.visible && a.points == b.points && a.look == b.look &&
           a.poseInMap.matrix() == b.poseInMap.matrix();
}

/// Whether @p now shows the same as @p before, plus newer scans.
bool continues(const SceneContent& before, const SceneContent& now) {
    return before.settings == now.settings && before.voxels == now.voxels &&
           before.scans.size() <= now.scans.size() &&
           std::equal(before.ghosts.begin(), before.ghosts.end(), now.ghosts.begin(), now.ghosts.end(),
                      alike) &&
           std::equal(before.scans.begin(), before.scans.end(), now.scans.begin(), alike);
}

/// A scan that is to be seen.
struct Seen {
    std::size_t at = 0;  ///< in SceneContent::scans; 0 for ghosts, which are in every picture
    const SceneScan* scan = nullptr;
};

/// A complete picture, held in the frame buffer until something else is drawn.
struct Whole {
    DrawOrder order;
    std::size_t scans = 0;                 ///< number of scans in it, the first ones
    double nearest = 0.0, farthest = 0.0;  ///< its clipping range [m]
};

}  // namespace

struct Scene::State {
    using Clock = std::chrono::steady_clock;

    std::unique_ptr<EglContext> context;  // outlives all VTK objects in it
    vtkNew<RenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    SceneContentPtr content = std::make_shared<const SceneContent>();
    std::vector<Seen> shown;     ///< scans and ghosts of the content
    bool many = false;           ///< too many are shown to draw each: the first pass draws a sample
    std::vector<ScanActor> few;  ///< the shown scans when they are not many
    PointsActor sample;
    double sampled = 1.0;  ///< share of every scan's points that is in the sample
    PointsActor some;      ///< points of many scans while the rest is drawn
    VoxelActor voxels;
    /// Budget of the first pass, in which each scan drawn by itself has a fixed cost.
    DetailBudget budget{QuickPicture};
    DetailBudget refining;  ///< budget of a refining pass
    bool fresh = true;      ///< the next pass also uploads: its time is not counted
    std::optional<Whole> whole;

    void choose();
    double begin(bool full);
    bool refine(double from, std::size_t first, const std::function<bool()>& interrupted);
    bool refineFew(double from, std::size_t first, const std::function<bool()>& interrupted);
    bool refineMany(double from, std::size_t first, const std::function<bool()>& interrupted);
    void drawSome(std::size_t points, Clock::time_point since);
    bool canContinue(const DrawOrder& order);
    bool continueWhole(const std::function<bool()>& interrupted);
    void keep(const MapPicture& picture);
};

/// Chooses the scans that are shown, and whether the first pass draws them or a sample of them.
void Scene::State::choose() {
    const auto clip = clipPlanes(content->settings);
    shown.clear();
    for (const SceneScan& ghost : content->ghosts) {
        if (isShown(ghost)) shown.push_back({0, &ghost});
    }
    for (std::size_t i = 0; i < content->scans.size(); ++i) {
        if (isShown(content->scans[i])) shown.push_back({i, &content->scans[i]});
    }
    many = shown.size() > Many;
    const std::size_t alone = many ? 0 : shown.size();
    while (few.size() > alone) {
        renderer->RemoveActor(few.back().points().actor());
        few.pop_back();
    }
    while (few.size() < alone) renderer->AddActor(few.emplace_back().points().actor());
    for (std::size_t i = 0; i < alone; ++i) {
        few[i].update(*shown[i].scan);
        few[i].points().setClip(clip);
        few[i].points().setVisible(true);
    }
    const SceneSample drawn = many ? sampleOf(content->scans, MostSampled, content->ghosts) : SceneSample();
    sampled = drawn.share;
    sample.update(drawn.points);
    sample.setClip(clip);
    sample.setVisible(many);
    some.setClip(clip);
}

/// Draws as large a share of every scan's points as the budget allows, and returns it. Of many scans it draws
/// a sample instead, the whole sample when @p full.
double Scene::State::begin(bool full) {
    const Clock::time_point start = Clock::now();
    std::size_t all = sample.shownPoints();
    for (ScanActor& scan : few) all += scan.points().shownPoints();
    const auto points = static_cast<double>(all);
    double share = std::min(1.0, static_cast<double>(budget.points()) / std::max(points, 1.0));
    if (many && full) share = 1.0;
    renderer->SetPreserveColorBuffer(false);
    renderer->SetPreserveDepthBuffer(false);
    sample.setRange(0.0, share);
    for (ScanActor& scan : few) scan.points().setRange(0.0, share);
    window->Render();
    window->WaitForCompletion();
    if (!std::exchange(fresh, false))
        budget.drawn(static_cast<std::size_t>(share * points), Clock::now() - start);
    return share * sampled;
}

/// Draws the points after share @p from on top of the picture, for the shown scans from the @p first on, some
/// at a time. False when interrupted.
bool Scene::State::refine(double from, std::size_t first, const std::function<bool()>& interrupted) {
    renderer->SetPreserveColorBuffer(true);
    renderer->SetPreserveDepthBuffer(true);
    for (ScanActor& scan : few) scan.points().setVisible(false);
    sample.setVisible(false);
    const bool hasVoxels = voxels.actor()->GetVisibility() != 0;
    voxels.actor()->VisibilityOff();  // already drawn
    const bool done = many ? refineMany(from, first, interrupted) : refineFew(from, first, interrupted);
    for (ScanActor& scan : few) scan.points().setVisible(true);
    sample.setVisible(many);
    voxels.actor()->SetVisibility(hasVoxels);
    return done;
}

bool Scene::State::refineFew(double from, std::size_t first, const std::function<bool()>& interrupted) {
    auto next = few.begin() + static_cast<std::ptrdiff_t>(first);
    while (next != few.end() && !interrupted()) {
        const Clock::time_point start = Clock::now();
        double points = 0.0;
        auto end = next;
        for (; end != few.end() && points < static_cast<double>(refining.points()); ++end) {
            end->points().setRange(from, 1.0);
            end->points().setVisible(true);
            points += (1.0 - from) * static_cast<double>(end->points().shownPoints());
        }
        drawSome(static_cast<std::size_t>(points), start);
        for (; next != end; ++next) next->points().setVisible(false);
    }
    return next == few.end();
}

bool Scene::State::refineMany(double from, std::size_t first, const std::function<bool()>& interrupted) {
    std::size_t next = first;
    some.setRange(0.0, 1.0);
    while (next < shown.size() && !interrupted()) {
        const Clock::time_point start = Clock::now();
        const auto drawn = std::make_shared<DrawnPoints>();
        for (; next < shown.size() && drawn->size() < std::min(refining.points(), MostAtOnce); ++next) {
            const SceneScan& scan = *shown[next].scan;
            const auto before = static_cast<std::size_t>(from * static_cast<double>(scan.look->shown));
            ShownPoints points(scan);
            points.skip(before);
            points.append(scan.look->shown - before, scan.poseInMap, *drawn);
        }
        some.update(drawn);
        some.setVisible(true);
        drawSome(drawn->size(), start);
        some.setVisible(false);
    }
    some.update(nullptr);
    return next >= shown.size();
}

/// Draws the visible points. The budget learns from @p points and the time since @p since.
void Scene::State::drawSome(std::size_t points, Clock::time_point since) {
    window->Render();
    window->WaitForCompletion();
    refining.drawn(points, Clock::now() - since);
}

/// Whether newer scans can be drawn on top of a whole picture of @p order. Their depths must lie within its
/// clipping range.
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

/// Draws the scans that are newer than the whole picture on top of it; false when interrupted.
bool Scene::State::continueWhole(const std::function<bool()>& interrupted) {
    const auto first = std::partition_point(shown.begin(), shown.end(),
                                            [this](const Seen& one) { return one.at < whole->scans; });
    return refine(0.0, static_cast<std::size_t>(first - shown.begin()), interrupted);
}

/// Records whether the frame buffer holds a whole picture.
void Scene::State::keep(const MapPicture& picture) {
    whole.reset();
    if (!picture.complete || !picture.order.full) return;
    const double* range = renderer->GetActiveCamera()->GetClippingRange();
    whole = {picture.order, content->scans.size(), range[0], range[1]};
}

Result<std::unique_ptr<Scene>> Scene::create(const EglDisplay& display) {
    auto context = EglContext::create(display);
    if (!context) return context.error();
    auto state = std::make_unique<State>();
    state->context = std::move(context).value();
    state->window->start(*state->context);
    state->renderer->AddActor(state->voxels.actor());
    for (PointsActor* points : {&state->sample, &state->some}) {
        points->setPose(Pose::Identity());
        state->renderer->AddActor(points->actor());
    }
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
    const double pointSize = PointSize * order.pixelRatio;
    for (ScanActor& scan : state.few) scan.points().setPointSize(pointSize);
    state.sample.setPointSize(pointSize);
    state.some.setPointSize(pointSize);

    MapPicture picture{{}, order, state.content, false};
    if (state.canContinue(order)) {
        picture.complete = state.continueWhole(interrupted);
    } else {
        const double share = state.begin(order.full);
        picture.complete = share >= 1.0 || (order.full && state.refine(share, 0, interrupted));
    }
    state.keep(picture);
    picture.image = state.window->read();
    picture.image.setDevicePixelRatio(order.pixelRatio);
    return picture;
}

}  // namespace leitstand
