#include "widgets/models/camera/camera_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "core/base/pose.h"
#include "core/event/stream_role.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct CameraTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::CameraPane)
};

constexpr auto Between = " · ";

QString wholeDegrees(double radians) {
    return numberText(std::abs(inDegrees(radians)), 0) + QChar(0xb0);
}

QStringList lookParts(const PanWords& words) {
    const auto small = [](double radians) { return std::abs(inDegrees(radians)) < 0.5; };
    QStringList parts;
    if (words.pan) {
        parts << (small(*words.pan)  ? CameraTexts::tr("pan %1")
                  : *words.pan > 0.0 ? CameraTexts::tr("pan %1 left")
                                     : CameraTexts::tr("pan %1 right"))
                     .arg(wholeDegrees(*words.pan));
    }
    if (words.tilt && !small(*words.tilt)) {
        parts << (*words.tilt > 0.0 ? CameraTexts::tr("%1 down") : CameraTexts::tr("%1 up"))
                     .arg(wholeDegrees(*words.tilt));
    }
    return parts;
}

QString grantText(const PanWords& words) {
    if (!words.heldBy.isEmpty()) return CameraTexts::tr("%1 turns the cameras").arg(words.heldBy);
    return words.waiting ? CameraTexts::tr("asking for the cameras") : QString();
}

}  // namespace

QString cameraTitle(const StreamDescription* stream) {
    if (stream == nullptr) return CameraTexts::tr("No camera");
    if (stream->role == StreamRole::Thermal)
        return stream->thermal.measured ? CameraTexts::tr("Infrared °C") : CameraTexts::tr("Infrared");
    if (stream->sensor == "left") return CameraTexts::tr("Left camera");
    if (stream->sensor == "right") return CameraTexts::tr("Right camera");
    if (stream->sensor == "omni") return CameraTexts::tr("Omnidirectional camera");
    return stream->sensor.empty() ? CameraTexts::tr("Camera") : othersText(stream->sensor);
}

QString contrastText(ContrastHelp help) {
    switch (help) {
        case ContrastHelp::Off:
            return {};
        case ContrastHelp::Gentle:
            return CameraTexts::tr("contrast raised");
        case ContrastHelp::Strong:
            return CameraTexts::tr("contrast raised strongly");
    }
    return {};
}

QString panText(const PanWords& words) {
    QStringList parts = lookParts(words);
    if (const QString grant = grantText(words); !grant.isEmpty()) {
        parts << grant;
    } else {
        if (!words.keys.isEmpty()) parts << CameraTexts::tr("%1 turn").arg(words.keys);
        if (!words.recentreKey.isEmpty()) parts << CameraTexts::tr("%1 re-centres").arg(words.recentreKey);
    }
    return parts.join(QString::fromUtf8(Between));
}

QString shortPanText(const PanWords& words) {
    QStringList parts = lookParts(words);
    if (const QString grant = grantText(words); !grant.isEmpty()) parts << grant;
    return parts.join(QString::fromUtf8(Between));
}

std::vector<AzimuthTick> azimuthTicks(const PanoramaShape& shape) {
    std::vector<AzimuthTick> ticks;
    if (shape.width <= 0) return ticks;
    for (int yaw = 150; yaw >= -150; yaw -= 30) {
        AzimuthTick tick;
        tick.place = shape.columnOf(degrees(yaw)) / shape.width;
        tick.major = yaw % 90 == 0;
        if (yaw == 0) tick.text = CameraTexts::tr("ahead");
        if (yaw == 90) tick.text = CameraTexts::tr("left 90°");
        if (yaw == -90) tick.text = CameraTexts::tr("right 90°");
        ticks.push_back(tick);
    }
    // What is behind is at both ends.
    for (const double place : {0.0, 1.0}) ticks.push_back({place, true, CameraTexts::tr("behind")});
    return ticks;
}

}  // namespace leitstand
