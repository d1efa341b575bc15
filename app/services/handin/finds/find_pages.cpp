#include "app/services/handin/finds/find_pages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/services/finds/evidence_picture.h"
#include "app/services/handin/frozen_traces.h"
#include "app/services/handin/report_source.h"
#include "core/base/words.h"
#include "core/event/event.h"
#include "core/event/find_sample.h"
#include "core/event/picture_samples.h"

namespace leitstand {
namespace {

constexpr std::size_t MostPictures = 4;  ///< per find
constexpr double Around = 2.5;           ///< margin about the way in its picture [m]
constexpr double LeastSide = 6.0;        ///< of that picture [m]

MapArea areaOf(const Way& way, const Eigen::Vector3d& place) {
    Eigen::Vector2d low = place.head<2>(), high = low;
    for (const Eigen::Vector3d& point : way.points) {
        low = low.cwiseMin(point.head<2>());
        high = high.cwiseMax(point.head<2>());
    }
    const Eigen::Vector2d half = (0.5 * (high - low).array() + Around).max(LeastSide / 2);
    const Eigen::Vector2d middle = 0.5 * (low + high);
    return {middle - half, middle + half};
}

/// Returns the name of a kind of evidence, for people.
std::string nameOf(const std::string& kind) {
    if (kind == "picture") return translate("leitstand::ReportText", "picture");
    if (kind == "thermal") return translate("leitstand::ReportText", "infrared picture");
    if (kind == "gas") return translate("leitstand::ReportText", "CO₂ value");
    if (kind == "scan") return translate("leitstand::ReportText", "scan");
    if (kind == "odometry") return translate("leitstand::ReportText", "robot's pose");
    return kind;
}

}  // namespace

FindPages pagesOf(const ReportFind& find, const ReportModel& model, ReportSource& source,
                  std::vector<std::string>& warnings) {
    FindPages pages;
    bool gasListed = false;  // a trace has many readings
    for (const VictimEvidence& evidence : find.sample.evidence) {
        const auto event = source.event(evidence, find.sample);
        if (!event) {
            if (evidence.kind == "gas" && std::exchange(gasListed, true)) continue;
            warnings.push_back(fill(translate("leitstand::ReportText", "{}: its {} is missing: {}"),
                                    find.name, nameOf(evidence.kind), event.error().text));
            continue;
        }
        if (const auto* sample = event->sample.as<PictureSample>()) {
            if (pages.pictures.size() >= MostPictures) {
                ++pages.morePictures;
                continue;
            }
            auto picture = evidencePicture(*sample, *event, source.robots());
            if (picture) {
                pages.pictures.push_back(std::move(picture).value());
            } else {
                warnings.push_back(fill(translate("leitstand::ReportText", "{}: its {} cannot be shown: {}"),
                                        find.name, nameOf(evidence.kind), picture.error().text));
            }
            continue;
        }
        addTrace(pages, *event, find, model, source);
    }
    joinGas(pages);
    if (!model.hasMap() || !find.position.allFinite()) return pages;
    PaintSettings settings;
    settings.area = areaOf(find.way, find.position);
    settings.title = false;
    settings.mostPixels = 1.5e6;
    pages.way = paintMap(drawingOf(model, mapAbout(model, find), ""), settings);
    for (const Eigen::Vector3d& point : find.way.points)
        pages.wayPixels.push_back(pages.way.pixelOf(point.head<2>()));
    return pages;
}

}  // namespace leitstand
