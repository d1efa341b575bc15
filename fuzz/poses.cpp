#include "core/io/clouds/tum.h"
#include "core/io/clouds/uos.h"
#include "core/io/graph/given_links.h"
#include "fuzz/input_file.h"

namespace {

template <class T>
void check(const leitstand::Result<T>& read) {
    leitstand::fuzz::require(read.ok() || !read.error().text.empty(), "an error that tells something");
}

}  // namespace

/// .pose, .frames, TUM trajectories, links by hand; the first byte chooses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    if (size == 0) return 0;
    const fuzz::InputFile input(data + 1, size - 1);
    if (data[0] % 4 == 0) check(readUosPose(input.path()));
    if (data[0] % 4 == 1) check(readUosFrames(input.path()));
    if (data[0] % 4 == 2) check(readTum(input.path()));
    if (data[0] % 4 == 3) check(readGivenLinks(input.path()));
    return 0;
}
