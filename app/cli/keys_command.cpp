#include <map>
#include <memory>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/console/output.h"
#include "app/cli/console/text_table.h"
#include "transport/security/keys.h"

namespace leitstand::cli {
namespace {

constexpr const char* Footer =
    R"(Security of DDS (DDS-Security 1.1) is off unless a process is given keys. With keys, everything in the domain is
encrypted, whoever has none of this keystore hears nothing and commands nothing, and each may do what its role says:
  station   reads everything, commands every robot, writes /leitstand/...
  robot     publishes below /NAME/ (not its own commands), reads what is addressed to it
  viewer    reads everything, may stop robots, cannot drive

What to do:
  1. leitstandctl keys --out KEYS --station station1 --robot kurt3d --viewer coach
     Called again with the same folder it adds identities to it.
  2. Copy KEYS/enclaves/NAME to the machine of that name, nothing else and to nobody else: key.pem in it is secret.
     KEYS/private makes identities: keep it off the network.
  3. Station: name the folder in the configuration. ROS 2 robot (stock, nothing to install): lay the folder at
     KEYSTORE/enclaves/NAME and start its nodes with
       export ROS_SECURITY_ENABLE=true ROS_SECURITY_STRATEGY=Enforce
       export ROS_SECURITY_KEYSTORE=/path/to/KEYSTORE ROS_SECURITY_ENCLAVE_OVERRIDE=/NAME
     Every node must stand in the namespace /NAME; for topics and services elsewhere use --allow:
       --allow kurt3d=rt/scan --allow 'kurt3d=rq/*' --allow 'kurt3d=rr/*'
     (rt/ topics, rq/ and rr/ services and actions). Clocks must be right to a day.
  4. Before the last day that `keys show` lists: --renew with the same names and roles; old keys go to KEYS/retired.
  5. Lost or stolen: --revoke NAME, then copy the new identity_ca.cert.pem to every machine and start its programs
     again. Until then the thief is still let in.
Exit codes: 0 ok, 1 the job failed or an identity cannot be used, 2 usage.)";

struct KeysOptions {
    std::filesystem::path folder;
    std::vector<std::string> stations, robots, viewers, allowed, selfDriving, revoked;
    KeySettings settings;
    bool json = false;
};

std::string day(Time time) {
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::to_time_t(
                                          std::chrono::time_point_cast<std::chrono::seconds>(time))));
}

int fail(const std::string& text) {
    printError("error: " + text);
    return 1;
}

nlohmann::ordered_json jsonOf(const KeyInfo& info) {
    nlohmann::ordered_json problem;  // null when all is well
    if (!info.problem.empty()) problem = info.problem;
    return {{"name", info.name},
            {"role", toString(info.role)},
            {"serial", info.serial},
            {"valid_from", day(info.validFrom)},
            {"valid_until", day(info.validUntil)},
            {"enclave", info.enclave.string()},
            {"revoked", info.revoked},
            {"problem", problem}};
}

/// Prints @p identities. Returns 1 when one that is not revoked cannot be used, else 0.
int report(const std::vector<KeyInfo>& identities, const nlohmann::ordered_json& more, bool json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::vector<std::vector<std::string>> rows = {{"name", "role", "valid until", "state", "enclave"}};
    bool usable = true;
    for (const KeyInfo& info : identities) {
        list.push_back(jsonOf(info));
        rows.push_back({info.name, toString(info.role), day(info.validUntil),
                        info.problem.empty() ? "ok" : info.problem, info.enclave.string()});
        if (!info.problem.empty() && !info.revoked) usable = false;
    }
    if (json) {
        nlohmann::ordered_json all = {{"identities", list}};
        all.update(more);
        printJson(all);
    } else {
        print(textTable(rows));
    }
    return usable ? 0 : 1;
}

int showKeys(const KeysOptions& options) {
    const auto keystore = readKeystore(options.folder);
    if (!keystore) return fail(keystore.error().text);
    for (const std::string& warning : keystore->warnings) {
        printError("warning: " + warning);
    }
    return report(keystore->identities, {{"authority_valid_until", day(keystore->authorityValidUntil)}},
                  options.json);
}

/// Returns the requests of @p options. Throws CLI::ValidationError when options do not fit each other.
std::vector<KeyRequest> requestsOf(const KeysOptions& options) {
    std::vector<KeyRequest> requests;
    const auto add = [&](KeyRole role, const std::vector<std::string>& names) {
        for (const std::string& name : names) requests.push_back({role, name, {}, false});
    };
    add(KeyRole::Station, options.stations);
    add(KeyRole::Robot, options.robots);
    add(KeyRole::Viewer, options.viewers);
    const auto find = [&](const std::string& option, const std::string& name) -> KeyRequest& {
        for (KeyRequest& request : requests) {
            if (request.name == name) return request;
        }
        throw CLI::ValidationError(option, fmt::format("\"{}\" is none of the names of this call", name));
    };
    for (const std::string& name : options.selfDriving) find("--self-driving", name).commandsItself = true;
    for (const std::string& allowed : options.allowed) {
        const auto equals = allowed.find('=');
        if (equals == std::string::npos) {
            throw CLI::ValidationError("--allow", "expected NAME=TOPIC, found \"" + allowed + "\"");
        }
        find("--allow", allowed.substr(0, equals)).moreTopics.push_back(allowed.substr(equals + 1));
    }
    return requests;
}

int revoke(const KeysOptions& options) {
    for (const std::string& name : options.revoked) {
        const auto count = revokeKeys(options.folder, name);
        if (!count) return fail(count.error().text);
        printError(fmt::format("{}: {} certificate(s) revoked; copy {} to every machine", name, *count,
                               (options.folder / "public/identity_ca.cert.pem").string()));
    }
    return 0;
}

int makeKeys(const KeysOptions& options, const std::vector<KeyRequest>& requests) {
    if (const int code = revoke(options); code != 0) return code;
    if (requests.empty()) return 0;
    const auto made = createKeys(options.folder, requests, options.settings);
    if (!made) return fail(made.error().text);
    return report(*made, nlohmann::ordered_json::object(), options.json);
}

void declareShow(CLI::App& command, const std::shared_ptr<KeysOptions>& options, int& exitCode) {
    CLI::App* show =
        command.add_subcommand("show", "lists the identities of a keystore and what is wrong with them");
    show->add_option("DIR", options->folder, "the keystore")->required()->option_text(" ");
    show->add_flag("--json", options->json, "print JSON in place of a table");
    show->final_callback([options, &exitCode] { exitCode = showKeys(*options); });
}

void declareMake(CLI::App& command, KeysOptions& options) {
    command.add_option("--out", options.folder, "the keystore; made where there is none")->option_text("DIR");
    command.add_option("--station", options.stations, "stations to make identities for")
        ->option_text("NAME...");
    command.add_option("--robot", options.robots, "robots, by their names in topics")->option_text("NAME...");
    command.add_option("--viewer", options.viewers, "viewers")->option_text("NAME...");
    command
        .add_option("--allow", options.allowed,
                    "a further DDS topic that NAME may publish and read; * and ? stand for anything")
        ->option_text("NAME=TOPIC...");
    command
        .add_option("--self-driving", options.selfDriving,
                    "robots that publish their own command topics, as navigation on board does")
        ->option_text("NAME...");
    command.add_option("--days", options.settings.days, "how long identities are valid")
        ->check(CLI::Range(1, 3'650).description(""))
        ->option_text("N (365)");
    command.add_flag("--renew", options.settings.renew, "replace identities that exist");
    command.add_option("--revoke", options.revoked, "withdraw the certificates of a name")
        ->option_text("NAME...");
    command.add_flag("--json", options.json, "print JSON in place of a table");
}

}  // namespace

void addKeys(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("keys", "makes identities for a secured domain (DDS-Security)");
    const auto options = std::make_shared<KeysOptions>();
    command->footer(Footer);
    declareMake(*command, *options);
    declareShow(*command, options, exitCode);
    command->final_callback([command, options, &exitCode] {
        if (!command->get_subcommands().empty()) return;
        if (options->folder.empty()) throw CLI::RequiredError("--out");
        const auto requests = requestsOf(*options);
        if (requests.empty() && options->revoked.empty()) {
            throw CLI::ValidationError("keys", "expected one of --station, --robot, --viewer, --revoke");
        }
        exitCode = makeKeys(*options, requests);
    });
}

}  // namespace leitstand::cli
