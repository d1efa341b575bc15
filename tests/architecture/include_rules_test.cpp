#include "tests/architecture/include_rules.h"

#include <algorithm>
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
    EXPECT_THAT(includeViolations("core/scan/scan.cpp", "#include <QString>\n#include <vtkActor.h>\n"),
                ElementsAre(HasSubstr("core/scan/scan.cpp:1: core may not use Qt"),
                            HasSubstr(":2: core may not use vtk")));
    EXPECT_THAT(includeViolations("core/scan/scan.cpp", "  #  include \"core/io/uos.h\"\n"),
                ElementsAre(HasSubstr("may not include core/io/uos.h")));
}

TEST(IncludeRules, TransportAndWidgetsNeverMeet) {
    EXPECT_THAT(includeViolations("widgets/drive/drive.cpp", "#include \"transport/node.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("transport/node.cpp", "#include \"widgets/theme.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("app/session/session.cpp", "#include \"transport/node.h\"\n"), IsEmpty());
}

TEST(IncludeRules, OnlyTheRobotsKnowTheSimulation) {
    EXPECT_THAT(includeViolations("app/window/main.cpp", "#include \"robots/simulation/world.h\"\n"),
                testing::SizeIs(1));
    EXPECT_THAT(includeViolations("robots/kurt3d/agent.cpp", "#include \"robots/simulation/world.h\"\n"),
                testing::SizeIs(1));
}

TEST(IncludeRules, FilesInUnknownFoldersAreFound) {
    EXPECT_THAT(includeViolations("misc/a.cpp", ""), ElementsAre(HasSubstr("no folder of design section 2")));
}

TEST(SourceSizes, NoFileIsLongerThan400Lines) {
    for (const std::string& file :
         sources({"core", "transport", "robots", "widgets", "app", "tests", "benchmarks", "fuzz"})) {
        const std::string text = content(file);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 400) << file;
    }
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
