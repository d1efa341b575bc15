#include "core/io/robot/service_reader.h"

#include <map>
#include <string>
#include <utility>

#include "core/base/words.h"
#include "core/io/robot/robot_keys.h"

namespace leitstand::detail {
namespace {

std::vector<std::string> knownTypes() {
    std::vector<std::string> types;
    for (const ServiceFacts& facts : serviceTable()) types.emplace_back(facts.type);
    return types;
}

bool readName(const YamlFields& fields, ServiceDescription& service) {
    if (!fields.has("name"))
        return fields.fail("name", translate("leitstand::Error",
                                             "expected a service such as /kurt3d/e_stop, found nothing"));
    if (!fields.text("name", service.name)) return false;
    if (isRosName(service.name)) return true;
    return fields.fail(
        "name", leitstand::fill(translate("leitstand::Error",
                                          "expected a service such as /kurt3d/e_stop (words of letters, "
                                          "digits and _ that begin with no digit), found {}"),
                                shown(service.name)));
}

bool readType(const YamlFields& fields, ServiceDescription& service) {
    if (fields.has("type") && !fields.text("type", service.type)) return false;
    if (serviceFacts(service.type) != nullptr) return true;
    const std::vector<std::string> known = knownTypes();
    return fields.fail("type",
                       leitstand::fill(translate("leitstand::Error", "expected {}, found {}{}"), anyOf(known),
                                       shown(service.type), likely(service.type, known)));
}

void readStop(const YamlFields& fields, ServiceDescription& service) {
    if (!fields.has("stop")) return;
    bool stop = false;
    if (!fields.flag("stop", stop)) return;
    service.stop = stop;
    const ServiceKind kind = serviceFacts(service.type)->kind;
    if (!stop && kind == ServiceKind::CancelGoal)
        fields.fail("stop", translate("leitstand::Error",
                                      "expected true, since a release gives no goals back, found false"));
}

}  // namespace

void readServices(const YamlFields& fields, RobotDescription& robot, YamlErrors& errors) {
    if (!fields.has("services")) return;
    std::map<std::string, int> lines;
    for (const YamlPlace& place : fields.list("services")) {
        const YamlFields one(place, ServiceKeys, errors);
        ServiceDescription service;
        if (!place.value.IsMap() || !readName(one, service) || !readType(one, service)) continue;
        one.text("title", service.title);
        readStop(one, service);
        const auto [first, added] = lines.emplace(service.name, one.at("name").line);
        if (!added)
            one.fail("name",
                     leitstand::fill(translate("leitstand::Error",
                                               "expected a service of its own, found {} of line {} again"),
                                     shown(service.name), first->second));
        robot.services.push_back(std::move(service));
    }
}

}  // namespace leitstand::detail
