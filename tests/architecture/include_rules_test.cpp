#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/architecture/sources.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(IncludeRules, EverySourceKeepsThem) {
    const auto files = sources({"core", "transport", "robots", "widgets", "app"});
    EXPECT_GT(files.size(), 10u) << "the sources were not found below " << sourceFolder();
    for (const std::string& file : files) {
        EXPECT_THAT(includeViolations(file, content(file)), IsEmpty());
    }
}

TEST(IncludeRules, CoreKnowsNoQtNoVtkAndNoFiles) {
    EXPECT_THAT(includeViolations("core/cloud/scan.cpp", "#include <QString>\n#include <vtkActor.h>\n"),
                ElementsAre(HasSubstr("core/cloud/scan.cpp:1: core may not use Qt"),
                            HasSubstr(":2: core may not use vtk")));
    EXPECT_THAT(includeViolations("core/cloud/scan.cpp", "  #  include \"core/io/clouds/uos.h\"\n"),
                testing::Contains(HasSubstr("core may not include core/io/clouds/uos.h")));
}

TEST(IncludeRules, TransportAndWidgetsNeverMeet) {
    EXPECT_THAT(includeViolations("widgets/drive/drive.cpp", "#include \"transport/node.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("transport/node.cpp", "#include \"widgets/painting/theme.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("app/services/session.cpp", "#include \"transport/node.h\"\n"), IsEmpty());
}

TEST(IncludeRules, OnlyTheRobotsKnowTheSimulation) {
    EXPECT_THAT(includeViolations("app/window/main.cpp", "#include \"robots/simulation/world.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("robots/kurt3d/agent.cpp", "#include \"robots/simulation/world.h\"\n"),
                testing::SizeIs(1));
}

TEST(IncludeRules, NoRoomIncludesOneThatStandsAboveIt) {
    EXPECT_THAT(
        includeViolations("core/robot/team.cpp", "\n#include \"core/mission/state/fold.h\"\n"),
        ElementsAre(HasSubstr("core/robot/team.cpp:2: core/mission/state/fold.h stands above core/robot")));
    EXPECT_THAT(includeViolations("core/mission/state/fold.cpp", "#include \"core/robot/team.h\"\n"),
                IsEmpty());
    EXPECT_THAT(includeViolations("widgets/map_view/scene/voxel_mesh.cpp",
                                  "#include \"widgets/map_view/map_view.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("app/services/log/a.cpp", "#include \"app/services/station/station.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("core/attic/a.cpp", ""),
                ElementsAre(HasSubstr("no room of the order of core")));
}

TEST(IncludeRules, FilesInUnknownFoldersAreFound) {
    EXPECT_THAT(includeViolations("misc/a.cpp", ""), ElementsAre(HasSubstr("no folder of design section 2")));
}

// A writer of exports without its row, a pane that no table names, a cue that nothing looks for.
TEST(IncludeRules, EveryHeaderIsUsedByAnotherFileOrIsAnInterfaceOfTheDocuments) {
    const auto files = sources({"core", "transport", "robots", "widgets", "app"});
    const std::regex include(R"re(#include "([^"]+)")re");
    std::set<std::string> used;
    for (const std::string& file : files) {
        const std::string text = content(file);
        const std::string own = file.substr(0, file.rfind('.')) + ".h";
        for (std::sregex_iterator one(text.begin(), text.end(), include), end; one != end; ++one)
            if (one->str(1) != own) used.insert(one->str(1));
    }
    std::string documents;
    for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() + "/docs"))
        if (entry.is_regular_file()) documents += content("docs/" + entry.path().filename().string());
    for (const std::string& file : files) {
        if (!file.ends_with(".h") || used.contains(file)) continue;
        EXPECT_THAT(documents, HasSubstr("(`" + file + "`)")) << file << ": no other file includes it";
    }
}

TEST(SourceSizes, NoFileIsLongerThan600LinesAndThoseOver400AreNamed) {
    for (const std::string& file :
         sources({"core", "transport", "robots", "widgets", "app", "tests", "benchmarks", "fuzz"})) {
        const std::string text = content(file);
        const auto lines = std::count(text.begin(), text.end(), '\n');
        if (lines > 400)
            std::printf("warning: %s has %td lines; over 400 it may hold two things\n", file.c_str(), lines);
        EXPECT_LE(lines, 600) << file;
    }
}

TEST(SourceSizes, NoFolderHasMoreThan20Files) {
    std::map<std::string, int> files;
    for (const std::string& file : sources({"core", "transport", "robots", "widgets", "app"}))
        ++files[file.substr(0, file.rfind('/'))];
    for (const auto& [folder, count] : files)
        EXPECT_LE(count, 20) << folder << ": part it into folders by what they mean";
}

TEST(ArchitectureDocument, NamesEveryFolderInALineAndNoneThatIsNotThere) {
    std::set<std::string> folders, named;
    for (const std::string& file : sources({"core", "transport", "robots", "widgets", "app"}))
        folders.insert(file.substr(0, file.rfind('/')));
    const std::string document = content("docs/architecture.md") + content("docs/architecture-programs.md");
    for (std::size_t at = document.find("\n| `"); at != std::string::npos;
         at = document.find("\n| `", at + 1)) {
        const std::string folder = document.substr(at + 4, document.find('`', at + 4) - at - 4);
        EXPECT_TRUE(named.insert(folder).second) << folder << " is named twice";
    }
    EXPECT_THAT(named, testing::ContainerEq(folders));
}

TEST(Recipes, NameFilesAndFoldersThatAreThere) {
    const std::string document = content("docs/recipes.md");
    int named = 0;
    for (std::size_t at = document.find('`'); at != std::string::npos; at = document.find('`', at + 1)) {
        const std::size_t end = document.find('`', at + 1);
        const std::string name = document.substr(at + 1, end - at - 1);
        at = end;
        const bool path = name.find('/') != std::string::npos && name.find("CODE") == std::string::npos;
        if (!path) continue;
        ++named;
        EXPECT_TRUE(std::filesystem::exists(sourceFolder() + "/" + name)) << name;
    }
    EXPECT_GT(named, 8);
}

TEST(SourceSizes, MainFilesHaveAtMost40Lines) {
    for (const std::string& file : sources({"app", "robots"})) {
        if (!file.ends_with("/main.cpp")) continue;
        const std::string text = content(file);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40) << file;
    }
}

}  // namespace
}  // namespace leitstand::test
