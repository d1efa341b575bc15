#include <cstdio>
#include <exception>

#include "app/window/application.h"

int main(int argc, char** argv) {
    try {
        return leitstand::runStation(argc, argv);
    } catch (const std::exception& broken) {
        std::fprintf(stderr, "leitstand: %s\n", broken.what());
        return 1;
    }
}
