#include "robots/simulation/simulated_hardware.h"

#include <set>
#include <utility>

#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "robots/simulation/fit_out.h"
#include "robots/simulation/sensors/camera/depth_camera.h"
#include "robots/simulation/sensors/camera/infrared_camera.h"
#include "robots/simulation/sensors/laser/plane_laser.h"
#include "robots/simulation/sensors/laser/spinning_lidar.h"
#include "robots/simulation/sensors/laser/tilting_scanner.h"
#include "robots/simulation/sensors/laser/turning_scanner.h"
#include "robots/simulation/sensors/state/battery.h"
#include "robots/simulation/sensors/state/detector.h"
#include "robots/simulation/sensors/state/gas_sensor.h"
#include "robots/simulation/sensors/state/reading_sensor.h"

namespace leitstand::simulation {
namespace {

constexpr double OwnHead = 0.14;  ///< the scanner's own housing lies nearer than this [m]

Pose at(double x, double y, double z) {
    return poseFrom({x, y, z}, 0.0, 0.0, 0.0);
}

Pose looking(const Pose& place, const Eigen::Matrix3d& axes) {
    Pose turned = place;
    turned.linear() = axes;
    return turned;
}

void addScanner(FitOut& fit, ScannerMount mount) {
    const auto place = fit.place(StreamRole::Points, {}, "laser", at(0.0, 0.0, 0.48));
    if (!place) return;
    fit.fix(place->frame, place->inBase);
    if (mount == ScannerMount::Tilting) {
        TiltingScannerSettings settings;
        settings.laser.nearest = OwnHead;
        settings.sensor = place->key;
        settings.frame = place->frame;
        settings.mountInBase = place->inBase;
        fit.add(std::make_unique<TiltingScanner>(settings, fit.noise("scanner"), fit.start()));
        return;
    }
    TurningScannerSettings settings = scanDrive();
    settings.laser.nearest = OwnHead;
    settings.sensor = place->key;
    settings.frame = place->frame;
    settings.mountInBase = place->inBase;
    fit.add(std::make_unique<TurningScanner>(settings, fit.noise("scanner"), fit.start()));
}

void addGas(FitOut& fit, const Pose& usual) {
    const auto place = fit.place(StreamRole::Gas, {}, "co2", usual);
    if (!place) return;
    GasSettings settings;
    settings.sensor = place->key;
    settings.frame = place->frame;
    settings.sensorInBase = place->inBase;
    fit.fix(place->frame, place->inBase);
    fit.add(std::make_unique<GasSensor>(settings, fit.noise("gas"), fit.start()));
}

void addBattery(FitOut& fit, BatterySettings settings) {
    settings.frame = fit.baseFrame();
    fit.add(std::make_unique<Battery>(settings, fit.noise("battery"), fit.start()));
}

std::unique_ptr<Camera> camera(FitOut& fit, const SensorPlace& place, const MountAt& mount,
                               const std::shared_ptr<SharedLight>& light,
                               const std::function<bool(std::string_view)>& mayDraw) {
    CameraSettings settings;
    settings.mayDraw = mayDraw;
    settings.model = pinholeCamera();
    settings.sensor = place.key;
    settings.frame = place.frame;
    settings.cameraInBase = mount;
    return std::make_unique<Camera>(settings, light, fit.noise(place.key), fit.start());
}

/// Puts the left camera on its own unit, the right and the infrared camera on the other one.
void addKurt3dCameras(FitOut& fit, const RobotDescription& description, const HardwareSettings& hardware) {
    const bool draw = hardware.cameras;
    const auto light = std::make_shared<SharedLight>();
    const auto placed = [&](StreamRole role, const char* key, const Pose& usual) {
        auto place = fit.place(role, key, key, looking(usual, opticalAxes()));
        if (place) place = opticalPlace(*place, opticalAxes());
        return place;
    };
    std::shared_ptr<MountedPanTilt> unit;
    if (const auto left = placed(StreamRole::Picture, "left", at(0.19, 0.08, 0.33))) {
        unit = fit.addPanTilt("left", *left);
        const MountAt mount = fit.mountOn(unit, *left);
        if (draw) fit.add(camera(fit, *left, mount, light, hardware.mayDraw));
    }
    const auto right = placed(StreamRole::Picture, "right", at(0.19, -0.08, 0.33));
    const auto infrared = placed(StreamRole::Thermal, "ir", at(0.19, -0.08, 0.36));
    if (!right && !infrared) return;
    unit = fit.addPanTilt("right", right ? *right : *infrared);
    if (right) {
        const MountAt mount = fit.mountOn(unit, *right);
        if (draw) fit.add(camera(fit, *right, mount, light, hardware.mayDraw));
    }
    if (!infrared) return;
    InfraredSettings settings;
    settings.mayDraw = hardware.mayDraw;
    settings.model = infraredOptics();
    settings.sensor = infrared->key;
    settings.frame = infrared->frame;
    settings.cameraInBase = fit.mountOn(unit, *infrared);
    if (const StreamDescription* stream = description.stream(StreamRole::Thermal, "ir")) {
        settings.scale = stream->thermal.scale;
        settings.offset = stream->thermal.offset;
    }
    if (draw) fit.add(std::make_unique<InfraredCamera>(settings, fit.noise("ir"), fit.start()));
}

void addOmni(FitOut& fit, const HardwareSettings& hardware) {
    const auto described =
        fit.place(StreamRole::Picture, "omni", "omni", looking(at(0.0, 0.0, 0.34), mirrorAxes()));
    if (!described) return;
    const SensorPlace place = opticalPlace(*described, mirrorAxes());
    fit.fix(place.frame, place.inBase);
    if (!hardware.cameras) return;
    CameraSettings settings;
    settings.mayDraw = hardware.mayDraw;
    settings.model = omnidirectionalCamera();
    settings.rate = 6.0;
    settings.quality = 55;
    settings.seesRobot = true;
    settings.sensor = place.key;
    settings.frame = place.frame;
    settings.cameraInBase = [pose = place.inBase](Time) { return pose; };
    settings.exposure.vignetting = 0.0F;
    fit.add(
        std::make_unique<Camera>(settings, std::make_shared<SharedLight>(), fit.noise("omni"), fit.start()));
}

void addPlaneLaser(FitOut& fit, bool turning) {
    const auto place = fit.place(StreamRole::Ranges, {}, "laser", at(0.14, 0.0, 0.17));
    if (!place) return;
    fit.fix(place->frame, place->inBase);
    if (!turning) {
        PlaneLaserSettings settings = hokuyoUrg();
        settings.sensor = place->key;
        settings.frame = place->frame;
        settings.laserInBase = place->inBase;
        fit.add(std::make_unique<PlaneLaser>(settings, fit.noise("laser"), fit.start()));
        return;
    }
    TurningScannerSettings settings = turningUrg();
    const auto points = fit.place(StreamRole::Points, {}, "laser", place->inBase);
    settings.sensor = points ? points->key : place->key;
    settings.rangesSensor = place->key;
    settings.frame = place->frame;
    settings.fanFrame = place->frame + "_fan";
    settings.mountInBase = place->inBase;
    fit.add(std::make_unique<TurningScanner>(settings, fit.noise("laser"), fit.start()));
}

/// Adds a sensor for each of a stock robot's readings.
void addReadings(FitOut& fit, const RobotDescription& description) {
    for (const StreamDescription& stream : description.streams) {
        if (stream.role != StreamRole::Reading) continue;
        const auto place = fit.place(StreamRole::Reading, stream.sensor, stream.sensor, at(0.2, 0.0, 0.2));
        if (!place) continue;
        ReadingSensorSettings settings;
        settings.type = stream.type;
        settings.sensor = place->key;
        settings.frame = place->frame;
        settings.sensorInBase = place->inBase;
        fit.fix(place->frame, place->inBase);
        fit.add(std::make_unique<ReadingSensor>(settings, fit.noise(place->key), fit.start()));
    }
}

/// Adds the lidar of a stock robot, and its depth cameras.
void addScanners(FitOut& fit, const RobotDescription& description, const HardwareSettings& settings) {
    std::set<std::string> added;
    for (const StreamDescription& stream : description.streams) {
        if (stream.role != StreamRole::Points || !added.insert(stream.sensor).second) continue;
        if (isDepthStream(stream)) {
            auto place = fit.place(StreamRole::Points, stream.sensor, stream.sensor,
                                   looking(at(0.1, 0.0, 0.2), opticalAxes()));
            if (!place) continue;
            place = opticalPlace(*place, opticalAxes());
            fit.fix(place->frame, place->inBase);
            if (!settings.cameras) continue;
            DepthCameraSettings depths = oakD();
            depths.sensor = place->key;
            depths.frame = place->frame;
            depths.cameraInBase = place->inBase;
            fit.add(std::make_unique<DepthCamera>(depths, fit.noise(place->key), fit.start()));
        } else if (const auto place =
                       fit.place(StreamRole::Points, stream.sensor, "lidar", at(0.0, 0.0, 0.5))) {
            SpinningLidarSettings lidar = settings.lidar;
            lidar.sensor = place->key;
            lidar.frame = place->frame;
            lidar.lidarInBase = place->inBase;
            if (settings.lidarMountTold) fit.fix(place->frame, place->inBase);
            fit.add(std::make_unique<SpinningLidar>(lidar, fit.noise("lidar"), fit.start()));
        }
    }
}

}  // namespace

std::unique_ptr<RobotHardware> makeKurt3dHardware(World& world, int robot,
                                                  const RobotDescription& description,
                                                  const HardwareSettings& settings) {
    FitOut fit(world, robot, description, settings.seed);
    fit.addReckoning();
    addScanner(fit, settings.scanner);
    addKurt3dCameras(fit, description, settings);
    addGas(fit, at(0.22, 0.0, 0.25));
    addBattery(fit, kurt3dBattery());
    return fit.finish();
}

std::unique_ptr<RobotHardware> makeCrawlerHardware(World& world, int robot,
                                                   const RobotDescription& description,
                                                   const HardwareSettings& settings) {
    FitOut fit(world, robot, description, settings.seed);
    fit.addReckoning();
    addPlaneLaser(fit, settings.turningLaser);
    addOmni(fit, settings);
    // The Crawler has a CO2 sensor only when its description gives it one.
    if (description.stream(StreamRole::Gas) != nullptr) addGas(fit, at(0.18, 0.0, 0.15));
    addBattery(fit, crawlerBattery());
    return fit.finish();
}

std::unique_ptr<RobotHardware> makeStockHardware(World& world, int robot, const RobotDescription& description,
                                                 const HardwareSettings& settings) {
    FitOut fit(world, robot, description, settings.seed);
    fit.addReckoning();
    addScanners(fit, description, settings);
    if (const auto place = fit.place(StreamRole::Ranges, {}, "laser", at(0.0, 0.0, 0.2))) {
        PlaneLaserSettings laser = rplidarA1();
        laser.sensor = place->key;
        laser.frame = place->frame;
        laser.laserInBase = place->inBase;
        fit.fix(place->frame, place->inBase);
        fit.add(std::make_unique<PlaneLaser>(laser, fit.noise("laser"), fit.start()));
    }
    if (auto place =
            fit.place(StreamRole::Picture, {}, "camera", looking(at(0.1, 0.0, 0.2), opticalAxes()))) {
        place = opticalPlace(*place, opticalAxes());
        fit.fix(place->frame, place->inBase);
        if (settings.cameras)
            fit.add(camera(
                fit, *place, [pose = place->inBase](Time) { return pose; }, std::make_shared<SharedLight>(),
                settings.mayDraw));
    }
    addReadings(fit, description);
    if (description.stream(StreamRole::Markers) != nullptr)
        fit.add(std::make_unique<Detector>(fit.baseFrame(), fit.start()));
    addBattery(fit, crawlerBattery());
    return fit.finish();
}

}  // namespace leitstand::simulation
