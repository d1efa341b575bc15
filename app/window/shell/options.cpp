#include "app/window/shell/options.h"

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/language/language.h"
#include "app/options/domain_options.h"
#include "app/services/offline/scan_session.h"
#include "app/window/shell/terminal.h"
#include "core/version/version.h"

namespace leitstand {
namespace {

constexpr int UsageError = 2;
constexpr const char* LiveGroup = "Live robots";
constexpr int LastDemoDomain = 132;  ///< the truth of simulated robots is on the domain 100 above
constexpr int SmallestSide = 320, LargestSide = 8192;  ///< [px]

/// Reads "1280x800" into @p size. Returns the error text; empty: none.
std::string parseSize(const std::string& text, std::optional<QSize>& size) {
    int width = 0, height = 0;
    char end = 0;
    const int found = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end);
    const auto fits = [](int side) { return side >= SmallestSide && side <= LargestSide; };
    if (found != 2 || !fits(width) || !fits(height)) {
        return "expected WIDTHxHEIGHT from 320x320 to 8192x8192, found \"" + text + "\"";
    }
    size = QSize(width, height);
    return {};
}

}  // namespace

std::variant<Options, int> parseOptions(int argc, const char* const* argv) {
    Options options;
    std::string size;
    CLI::App app("Leitstand, the operator station for rescue robots: registers 3D scans and shows them.",
                 "leitstand");
    app.set_version_flag("--version", versionOf("leitstand"));
    app.add_option("SCANS", options.scans,
                   fmt::format("Scan files ({}), folders of them, and missions (rosbag2) to open",
                               fmt::join(scanEndings(), " ")));
    app.add_flag("--register-again", options.registerAgain,
                 "Register the scans of a mission again, where it would be reviewed otherwise");
    const std::map<std::string, MapLook> looks = {
        {"points", MapLook::Points}, {"voxels", MapLook::Voxels}, {"top", MapLook::Top}};
    const std::map<std::string, Theme> themes = {{"dark", Theme::Dark}, {"light", Theme::Light}};
    auto* screenshot =
        app.add_option("--screenshot", options.screenshot,
                       "Write a picture of the window when all is shown, and quit; needs no display")
            ->type_name("FILE");
    app.add_option("--look", options.look, "points, voxels or top")
        ->transform(CLI::CheckedTransformer(looks).description(""))
        ->type_name("LOOK");
    app.add_option("--theme", options.theme, "dark or light")
        ->transform(CLI::CheckedTransformer(themes).description(""))
        ->type_name("THEME");
    std::vector<std::string> codes;
    for (const Language& language : languages()) codes.push_back(language.code.toStdString());
    app.add_option("--language", options.language,
                   fmt::format("{} (as chosen last, else the user's)", fmt::join(codes, "|")))
        ->check(CLI::IsMember(codes, CLI::ignore_case).description(""))
        ->type_name("LANGUAGE");
    app.add_option("--size", size, "Size of the screenshot in pixels, at any scale (a window of 1280x800)")
        ->type_name("WxH")
        ->needs(screenshot)
        ->check([&options](const std::string& text) { return parseSize(text, options.size); });
    auto* live =
        app.add_flag("--live", options.live, "Drive robots that are in the domain: open the station on them");
    auto* demo = app.add_flag("--demo", options.demo,
                              "Drive a simulated Kurt3D and Crawler, which are started beside the station");
    const auto onRobots = [&](CLI::Option* option, CLI::Option* with) {
        option->group(LiveGroup);
        if (with != nullptr) option->excludes(with);
        return option;
    };
    onRobots(live, demo);
    onRobots(demo, nullptr);
    onRobots(app.add_option("--robot", options.robots,
                            "Robot files, or names of shipped ones (kurt3d, crawler, turtlebot, turtlebot4, "
                            "husky, ouster, livox, tracked)"),
             demo)
        ->type_name("YAML...");
    auto* mission =
        onRobots(app.add_option(
                     "--mission", options.mission,
                     "Folder to record into; one that exists is gone on with (a new one, named by the time)"),
                 nullptr);
    mission->type_name("FOLDER");
    onRobots(app.add_flag("--resume", options.resume,
                          "Go on with the newest of the missions named by the time, as after a crash; alone: "
                          "with the robots of last time"),
             mission);
    onRobots(app.add_option("--map-of", options.mapOf,
                            "A new mission begins in the map of this one, which is copied"),
             nullptr)
        ->type_name("FOLDER");
    onRobots(app.add_option("--layout", options.layout,
                            "How panes are arranged: drive, explore, map, review, link, or one of your own"),
             nullptr)
        ->type_name("NAME");
    onRobots(app.add_option("--after", options.after,
                            "Take the screenshot so much later; the robots of --demo explore meanwhile"),
             nullptr)
        ->needs(screenshot)
        ->check(CLI::Range(0, 3600))
        ->type_name("SECONDS");
    addDomainOptions(app, options.network, LiveGroup);
    for (const char* option : {"--keys", "--peer", "--discovery-server"})
        app.get_option(option)->excludes(demo);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? 0 : UsageError;
    }
    options.live = options.live || options.demo;
    if (options.demo && options.network.domain.value_or(0) > LastDemoDomain) {
        printProblem("--demo: --domain: expected 0 to 132");
        return UsageError;
    }
    if (!options.live && !options.resume) {
        for (const CLI::Option* option : app.get_options()) {
            if (option->get_group() != LiveGroup || option->count() == 0 || option->get_name() == "--layout")
                continue;
            printProblem(option->get_name() + " is for live robots: expected --live or --demo beside it");
            return UsageError;
        }
    }
    if (!options.mapOf.empty() && (!options.live || options.resume)) {
        printProblem("--map-of begins a new mission on live robots: --live or --demo, without --resume");
        return UsageError;
    }
    if ((options.live || options.resume) && !options.scans.empty()) {
        printProblem("--live, --demo and --resume take no scans");
        return UsageError;
    }
    return options;
}

}  // namespace leitstand
