#include <exception>

#include "app/window/application.h"
#include "app/window/shell/terminal.h"

int main(int argc, char** argv) {
    try {
        return leitstand::runStation(argc, argv);
    } catch (const std::exception& broken) {
        leitstand::printProblem(broken.what());
        return 1;
    }
}
