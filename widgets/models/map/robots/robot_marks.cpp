#include "widgets/models/map/robots/robot_marks.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

#include "core/event/motion_samples.h"
#include "core/robot/model/model_body.h"
#include "widgets/models/map/place_text.h"

namespace leitstand {
namespace {

/// Radius around a drawn robot whose scan fits badly, within which it is [m]; larger when less is certain.
constexpr double LeastDoubt = 0.3, MoreDoubt = 0.7;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RobotMark)
};

}  // namespace

std::optional<RobotMark> robotMarkOf(const RobotFace& face, const RobotDescription& robot,
                                     const RobotInMap& place, const LinkStatus& link, bool selected,
                                     const std::optional<Pose>& goalInMap) {
    if (!place.placed) return std::nullopt;
    RobotMark mark;
    mark.face = face;
    mark.footprint = robot.footprint;
    mark.height = robot.height;
    mark.tracked = robot.drive == DriveType::Tracked;
    mark.baseInMap = place.baseInMap;
    mark.trail = place.trail;
    mark.afterGap = place.afterGap;
    mark.goalInMap = goalInMap;
    mark.selected = selected;
    mark.details = face.title + QStringLiteral(": ") + placeText(place);
    mark.stale = link.state == LinkState::Lost;
    if (!place.certain) {
        mark.doubtRadius = LeastDoubt + MoreDoubt * (1.0 - std::clamp(place.certainty, 0.0, 1.0));
        mark.note = Texts::tr("place uncertain");
        mark.tone = Tone::Attention;
    }
    if (mark.stale) {
        mark.note = Texts::tr("link lost: seen here last");
        mark.details += QStringLiteral(" · ") + mark.note;
        mark.tone = Tone::Attention;
    }
    return mark;
}

void setBody(RobotMark& mark, ModelBodyPtr body, const RobotView& view) {
    mark.body = std::move(body);
    if (!mark.body) return;
    std::unordered_map<std::string_view, double> positions;
    if (const JointSample* const joints = view.joints.get(); joints != nullptr) {
        const std::size_t count = std::min(joints->names.size(), joints->positions.size());
        for (std::size_t i = 0; i < count; ++i) positions.emplace(joints->names[i], joints->positions[i]);
    }
    mark.linksInBase =
        linksInBase(mark.body->model, mark.body->base, [&](const std::string& name) -> std::optional<double> {
            const auto found = positions.find(name);
            return found == positions.end() ? std::nullopt : std::optional(found->second);
        });
}

bool sameMark(const RobotMark& a, const RobotMark& b) {
    const auto sameGoal = [](const std::optional<Pose>& x, const std::optional<Pose>& y) {
        return x.has_value() == y.has_value() && (!x || x->matrix() == y->matrix());
    };
    const auto samePlace = [](const Pose& x, const Pose& y) { return x.matrix() == y.matrix(); };
    return a.face == b.face && a.body == b.body &&
           std::equal(a.linksInBase.begin(), a.linksInBase.end(), b.linksInBase.begin(), b.linksInBase.end(),
                      samePlace) &&
           a.baseInMap.matrix() == b.baseInMap.matrix() && a.trail == b.trail && a.afterGap == b.afterGap &&
           a.plans == b.plans && a.drawings == b.drawings && sameGoal(a.goalInMap, b.goalInMap) &&
           std::equal(a.waypoints.begin(), a.waypoints.end(), b.waypoints.begin(), b.waypoints.end(),
                      samePlace) &&
           a.doubtRadius == b.doubtRadius && a.note == b.note && a.tone == b.tone &&
           a.selected == b.selected && a.stale == b.stale;
}

QString detailsOf(const std::vector<RobotMark>& marks) {
    QStringList lines;
    for (const RobotMark& mark : marks) {
        if (!mark.details.isEmpty()) lines += mark.details;
    }
    return lines.join(QLatin1Char('\n'));
}

QString unplacedText(const std::vector<RobotFace>& unplaced, const QString& placeKeys) {
    if (unplaced.empty()) return {};
    QStringList titles;
    for (const RobotFace& face : unplaced) titles += face.title;
    const QString names = titles.join(QStringLiteral(", "));
    if (placeKeys.isEmpty()) return Texts::tr("%1 is not in the map yet").arg(names);
    return Texts::tr("%1 is not in the map yet · %2 places it").arg(names, placeKeys);
}

}  // namespace leitstand
