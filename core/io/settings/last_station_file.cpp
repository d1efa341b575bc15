#include "core/io/settings/last_station_file.h"

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

#include "core/io/detail/output_file.h"
#include "core/io/yaml/yaml_document.h"

namespace leitstand {
namespace {

constexpr int LastDomain = 232;

std::vector<std::string> wordsOf(const YAML::Node& list) {
    std::vector<std::string> words;
    for (const YAML::Node& word : list) words.push_back(word.as<std::string>());
    return words;
}

void write(YAML::Emitter& out, const char* key, const std::vector<std::string>& words) {
    out << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const std::string& word : words) out << YAML::DoubleQuoted << word;
    out << YAML::EndSeq;
}

}  // namespace

std::optional<LastStation> readLastStation(const std::filesystem::path& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    const auto root = detail::loadYaml(text.str(), file.string());
    if (!root || !root->IsMap()) return std::nullopt;
    try {
        LastStation station;
        station.robots = wordsOf((*root)["robots"]);
        // Files of before 0.3 name the domain always; 0 there was nobody's choice.
        const int domain = (*root)["domain"].as<int>();
        if ((*root)["domain_chosen"].as<bool>(domain != 0)) station.domain = domain;
        station.interfaces = wordsOf((*root)["interfaces"]);
        station.initialPeers = wordsOf((*root)["peers"]);  // not in files of before 0.3
        station.discoveryServer = (*root)["discovery_server"].as<std::string>("");
        station.keys = (*root)["keys"].as<std::string>();
        const bool sound = !station.robots.empty() && domain >= 0 && domain <= LastDomain;
        return sound ? std::optional(station) : std::nullopt;
    } catch (const YAML::Exception&) {
        return std::nullopt;
    }
}

Result<void> writeLastStation(const std::filesystem::path& file, const LastStation& station) {
    YAML::Emitter out;
    out << YAML::Comment("With what the station was opened last: `leitstand` opens it so again.");
    out << YAML::BeginMap;
    write(out, "robots", station.robots);
    out << YAML::Key << "domain" << YAML::Value << station.domain.value_or(0);
    if (station.domain == 0) out << YAML::Key << "domain_chosen" << YAML::Value << true;
    write(out, "interfaces", station.interfaces);
    if (!station.initialPeers.empty()) write(out, "peers", station.initialPeers);
    if (!station.discoveryServer.empty())
        out << YAML::Key << "discovery_server" << YAML::Value << YAML::DoubleQuoted
            << station.discoveryServer;
    out << YAML::Key << "keys" << YAML::Value << YAML::DoubleQuoted << station.keys;
    out << YAML::EndMap << YAML::Newline;
    std::error_code problem;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), problem);
    return detail::writeWhole(file, out.c_str());
}

}  // namespace leitstand
