#include "widgets/models/coverage/sensor_text.h"

#include <QCoreApplication>

namespace leitstand {

QString sensorText(SearchSensor sensor) {
    switch (sensor) {
        case SearchSensor::Camera:
            return QCoreApplication::translate("leitstand::Coverage", "Camera");
        case SearchSensor::Infrared:
            return QCoreApplication::translate("leitstand::Coverage", "Infrared");
        case SearchSensor::Scanner:
            break;
    }
    return QCoreApplication::translate("leitstand::Coverage", "Scanner");
}

}  // namespace leitstand
