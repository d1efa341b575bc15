#include "widgets/map_view/render/actors.h"

#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>

#include "widgets/map_view/render/range_mapper.h"

namespace leitstand {
namespace {

static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float) && sizeof(Rgba) == 4);

// VTK's arrays refer to our memory and never write or free it, although their interface is not const.
constexpr int KeepMemory = 1;

vtkNew<vtkPoints> pointsOver(const std::vector<Eigen::Vector3f>& positions) {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetArray(const_cast<float*>(positions.data()->data()),
                    3 * static_cast<vtkIdType>(positions.size()), KeepMemory);
    vtkNew<vtkPoints> points;
    points->SetData(array);
    return points;
}

vtkNew<vtkUnsignedCharArray> coloursOver(const std::vector<Rgba>& colours) {
    vtkNew<vtkUnsignedCharArray> array;
    array->SetNumberOfComponents(4);
    array->SetArray(const_cast<unsigned char*>(&colours.data()->r),
                    4 * static_cast<vtkIdType>(colours.size()), KeepMemory);
    return array;
}

vtkNew<vtkTypeInt32Array> connectivityOver(const std::vector<std::int32_t>& indices) {
    vtkNew<vtkTypeInt32Array> connectivity;
    connectivity->SetArray(const_cast<std::int32_t*>(indices.data()), static_cast<vtkIdType>(indices.size()),
                           KeepMemory);
    return connectivity;
}

vtkNew<vtkCellArray> trianglesOver(const std::vector<std::int32_t>& indices) {
    vtkNew<vtkCellArray> cells;
    cells->SetData(3, connectivityOver(indices));
    return cells;
}

void useColoursAsTheyAre(vtkMapper* mapper) {
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointData();
    mapper->ScalarVisibilityOn();
    mapper->SetStatic(true);
}

vtkNew<vtkMatrix4x4> matrixOf(const Pose& pose) {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            matrix->SetElement(row, column, pose.matrix()(row, column));
        }
    }
    return matrix;
}

}  // namespace

PointsActor::PointsActor()
    : m_mapper(vtkSmartPointer<RangeMapper>::New()), m_actor(vtkSmartPointer<vtkActor>::New()) {
    useColoursAsTheyAre(m_mapper);
    m_mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    m_actor->SetMapper(m_mapper);
    m_actor->GetProperty()->LightingOff();
    m_actor->ForceOpaqueOn();
    m_actor->VisibilityOff();
}

PointsActor::~PointsActor() = default;

void PointsActor::update(DrawnPointsPtr points) {
    if (points == m_points) return;
    const DrawnPointsPtr former = std::exchange(m_points, std::move(points));
    if (shownPoints() == 0) {
        m_mapper->SetInputDataObject(nullptr);
        return;
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(pointsOver(m_points->points));
    data->GetPointData()->SetScalars(coloursOver(m_points->colours));
    m_mapper->SetInputData(data);
    m_mapper->Update();
    // The former memory is freed only here, after VTK has released it.
}

void PointsActor::setPose(const Pose& poseInMap) {
    m_actor->SetUserMatrix(matrixOf(poseInMap));
}

void PointsActor::setVisible(bool visible) {
    m_actor->SetVisibility(visible && shownPoints() > 0);
}

void PointsActor::setClip(vtkPlaneCollection* planesInMap) {
    m_mapper->SetClippingPlanes(planesInMap);
}

void PointsActor::setPointSize(double devicePixels) {
    m_actor->GetProperty()->SetPointSize(static_cast<float>(devicePixels));
}

void PointsActor::setRange(double from, double to) {
    m_mapper->setRange(from, to);
}

void ScanActor::update(const SceneScan& scan) {
    if (scan.points != m_scan || *scan.look != m_look) {
        m_scan = scan.points;
        m_look = *scan.look;
        m_points.update(drawnPoints(scan));
    }
    m_points.setPose(scan.poseInMap);
}

VoxelActor::VoxelActor() : m_actor(vtkSmartPointer<vtkActor>::New()) {
    m_actor->GetProperty()->LightingOff();
    m_actor->GetProperty()->BackfaceCullingOn();
    m_actor->ForceOpaqueOn();
    m_actor->VisibilityOff();
}

VoxelActor::~VoxelActor() = default;

void VoxelActor::update(std::shared_ptr<const VoxelMesh> mesh) {
    if (mesh == m_mesh) return;
    const auto former = std::exchange(m_mesh, std::move(mesh));
    const bool shown = m_mesh && !m_mesh->triangles.empty();
    m_actor->SetVisibility(shown);
    vtkNew<vtkPolyDataMapper> mapper;
    useColoursAsTheyAre(mapper);
    if (shown) {
        vtkNew<vtkPolyData> data;
        data->SetPoints(pointsOver(m_mesh->vertices));
        data->GetPointData()->SetScalars(coloursOver(m_mesh->colours));
        data->SetPolys(trianglesOver(m_mesh->triangles));
        mapper->SetInputData(data);
    }
    mapper->Update();
    m_actor->SetMapper(mapper);
}

}  // namespace leitstand
