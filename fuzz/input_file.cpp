#include "fuzz/input_file.h"

#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace leitstand::fuzz {

InputFile::InputFile(const std::uint8_t* data, std::size_t size) {
    static const int handle = memfd_create("input", MFD_CLOEXEC);
    require(handle >= 0 && ftruncate(handle, 0) == 0, "a file in memory");
    require(pwrite(handle, data, size, 0) == static_cast<ssize_t>(size), "the input in a file");
    m_path = "/proc/self/fd/" + std::to_string(handle);
}

int requireNamed(const Error& error, const char* name) {
    require(error.text.starts_with(name), "an error that names its file");
    require(error.text.size() < 100'000, "errors that can be read");
    return 0;
}

void require(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "fuzz: expected %s\n", what);
    std::abort();
}

}  // namespace leitstand::fuzz
