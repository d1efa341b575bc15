// The process beside a station that stops a robot without a watchdog when the station hangs or dies.
#include <csignal>
#include <cstdio>
#include <vector>

#include <malloc.h>
#include <unistd.h>

#include "core/base/printable.h"
#include "core/version/version.h"
#include "transport/link/guard_arguments.h"
#include "transport/security/enclave.h"

int main(int argc, char** argv) {
    using namespace leitstand;
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (!words.empty() && words.front() == "--help") return std::puts(guardHelp().c_str()) < 0 ? 1 : 0;
    if (!words.empty() && words[0] == "--version") return std::puts(versionOf("leitstand-guard").data()) < 0;
    const auto fail = [](const Error& error, int code) {
        std::fprintf(stderr, "leitstand-guard: %s\n", printable(error.text).c_str());
        return code;
    };
    mallopt(M_ARENA_MAX, 1);  // many threads that allocate little
    for (const int ignored : {SIGINT, SIGHUP}) std::signal(ignored, SIG_IGN);  // it ends with the station
    const auto arguments = guardArgumentsFrom(words);
    if (!arguments) return fail(arguments.error(), 2);
    NodeSettings network = arguments->network;
    network.name = arguments->guard.ownName;
    if (!arguments->keys.empty()) {
        const auto files = securityFiles(arguments->keys);
        if (!files) return fail(files.error(), 1);
        network.security = *files;
    }
    const auto node = Node::create(network);
    if (!node) return fail(node.error(), 1);
    const auto guard = DriveGuard::create(**node, arguments->guard);
    if (!guard) return fail(guard.error(), 1);
    (*guard)->serve(STDIN_FILENO);
    return 0;
}
