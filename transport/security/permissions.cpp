#include "transport/security/permissions.h"

#include <array>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace leitstand {
namespace {

using Topics = std::vector<std::string>;

/// Last parts of the topics that command a robot (docs/design.md, "The wire").
constexpr std::array<const char*, 8> Commands = {"cmd_vel",   "track_cmd", "stop_cmd",   "mode_cmd",
                                                 "goal_pose", "ptu_cmd",   "stream_cmd", "ping"};

/// Topics that every ROS 2 process has beside its own.
const Topics RosTopics = {"ros_discovery_info", "rt/rosout", "rt/parameter_events"};

/// Returns the topics of @p command of any robot, also of one whose topics have no name before them.
Topics ofAnyRobot(const std::string& command) {
    return {"rt/" + command, "rt/*/" + command};
}

void append(Topics& topics, const Topics& more) {
    topics.insert(topics.end(), more.begin(), more.end());
}

std::string domains() {
    return "<domains><id_range><min>0</min><max>232</max></id_range></domains>";
}

std::string criteria(const char* kind, const Topics& topics) {
    if (topics.empty()) return {};
    std::string text = fmt::format("        <{}>\n          <topics>\n", kind);
    for (const std::string& topic : topics) {
        text += fmt::format("            <topic>{}</topic>\n", xmlEscaped(topic));
    }
    return text + fmt::format("          </topics>\n        </{}>\n", kind);
}

std::string rule(const char* kind, const Topics& publish, const Topics& subscribe) {
    if (publish.empty() && subscribe.empty()) return {};
    return fmt::format("      <{}>\n        {}\n{}{}      </{}>\n", kind, domains(),
                       criteria("publish", publish), criteria("subscribe", subscribe), kind);
}

std::string stationRules(const KeyRequest& request) {
    Topics publish = request.moreTopics;
    for (const char* command : Commands) append(publish, ofAnyRobot(command));
    publish.emplace_back("rt/leitstand/*");
    publish.emplace_back("rq/*");  // requests of services and actions
    append(publish, RosTopics);
    return rule("allow_rule", publish, {"*"});
}

std::string viewerRules(const KeyRequest& request) {
    Topics publish = request.moreTopics;
    append(publish, ofAnyRobot("stop_cmd"));
    append(publish, ofAnyRobot("ping"));
    append(publish, RosTopics);
    return rule("allow_rule", publish, {"*"});
}

std::string robotRules(const KeyRequest& request) {
    const std::string& name = request.name;
    Topics own = request.moreTopics;
    // rq and rr are services: requests and replies, also those of actions.
    append(own, {"rt/" + name + "/*", "rq/" + name + "/*", "rr/" + name + "/*"});
    append(own, {"rt/tf", "rt/tf_static", "rt/diagnostics"});
    append(own, RosTopics);
    Topics subscribe = own;
    append(subscribe, {"rt/leitstand/*", "rt/clock"});
    Topics forbidden;
    if (!request.commandsItself) {
        for (const char* command : Commands) forbidden.push_back("rt/" + name + "/" + command);
    }
    // The first rule that contains the topic decides.
    return rule("deny_rule", forbidden, {}) + rule("allow_rule", own, subscribe);
}

std::string rulesOf(const KeyRequest& request) {
    switch (request.role) {
        case KeyRole::Station:
            return stationRules(request);
        case KeyRole::Robot:
            return robotRules(request);
        case KeyRole::Viewer:
            break;
    }
    return viewerRules(request);
}

std::string topicRule(const std::string& expression, const char* protection) {
    return fmt::format(R"(        <topic_rule>
          <topic_expression>{}</topic_expression>
          <enable_discovery_protection>true</enable_discovery_protection>
          <enable_liveliness_protection>true</enable_liveliness_protection>
          <enable_read_access_control>true</enable_read_access_control>
          <enable_write_access_control>true</enable_write_access_control>
          <metadata_protection_kind>{}</metadata_protection_kind>
          <data_protection_kind>NONE</data_protection_kind>
        </topic_rule>
)",
                       xmlEscaped(expression), protection);
}

std::string utc(Time time) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(
                           std::chrono::time_point_cast<std::chrono::system_clock::duration>(time))));
}

}  // namespace

std::string xmlEscaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&apos;";
                break;
            default:
                if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) escaped += c;
        }
    }
    return escaped;
}

std::string governanceXml() {
    std::string topics;
    for (const char* command : Commands) {
        for (const std::string& topic : ofAnyRobot(command)) {
            topics += topicRule(topic, "SIGN_WITH_ORIGIN_AUTHENTICATION");
        }
    }
    topics += topicRule("*", "NONE");
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_governance.xsd">
  <domain_access_rules>
    <domain_rule>
      {}
      <allow_unauthenticated_participants>false</allow_unauthenticated_participants>
      <enable_join_access_control>true</enable_join_access_control>
      <discovery_protection_kind>ENCRYPT</discovery_protection_kind>
      <liveliness_protection_kind>ENCRYPT</liveliness_protection_kind>
      <rtps_protection_kind>ENCRYPT</rtps_protection_kind>
      <topic_access_rules>
{}      </topic_access_rules>
    </domain_rule>
  </domain_access_rules>
</dds>
)",
                       domains(), topics);
}

std::string permissionsXml(const KeyRequest& request, const std::string& subject, Time from, Time until) {
    constexpr auto Day = std::chrono::hours(24);
    return fmt::format(R"(<?xml version="1.0" encoding="UTF-8"?>
<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_permissions.xsd">
  <permissions>
    <grant name="{}">
      <subject_name>{}</subject_name>
      <validity>
        <not_before>{}</not_before>
        <not_after>{}</not_after>
      </validity>
{}      <default>DENY</default>
    </grant>
  </permissions>
</dds>
)",
                       xmlEscaped(request.name), xmlEscaped(subject), utc(from - Day), utc(until + Day),
                       rulesOf(request));
}

}  // namespace leitstand
