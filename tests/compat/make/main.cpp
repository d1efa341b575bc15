// compat_fixtures home HOME MISSION | mission FOLDER: fixtures of tests/compat, written by the program as it
// is.
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>

#include <QApplication>
#include <QLocale>

#include "tests/compat/lines.h"
#include "tests/compat/make/fixtures.h"

namespace fs = std::filesystem;

int main(int argc, char** argv) {
    const bool home = argc == 4 && std::strcmp(argv[1], "home") == 0;
    if (!home && !(argc == 3 && std::strcmp(argv[1], "mission") == 0)) {
        std::fputs("compat_fixtures home HOME MISSION | mission FOLDER\n", stderr);
        return 2;
    }
    try {
        if (!home) return leitstand::test::makeMission(fs::absolute(argv[2])), 0;
        const fs::path folder = fs::absolute(argv[2]);
        fs::create_directories(folder);
        qputenv("HOME", folder.c_str());
        qputenv("XDG_CONFIG_HOME", (folder / ".config").c_str());
        qputenv("XDG_DATA_HOME", (folder / ".local/share").c_str());
        const std::string screen = leitstand::test::compatFile("screen.json").string();
        qputenv("QT_QPA_PLATFORM", ("offscreen:configfile=" + screen).c_str());
        QApplication application(argc, argv);
        QApplication::setApplicationName(QStringLiteral("leitstand"));
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        leitstand::test::makeHome(folder, fs::absolute(argv[3]));
        return 0;
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
}
