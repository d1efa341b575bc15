#include <string>

#include "core/io/model/urdf.h"
#include "core/robot/model/model_body.h"
#include "fuzz/input_file.h"

/// Models of robots; what can be read is also given a surface.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const auto model = readUrdf(std::string(reinterpret_cast<const char*>(data), size), "robot");
    fuzz::require(model.ok() || !model.error().text.empty(), "an error that tells something");
    if (!model) return 0;
    const ModelBody body = bodyOf(*model, "base_link",
                                  [](const std::string& uri) -> Result<TriangleMesh> { return Error{uri}; });
    for (const Pose& pose : linksInBase(body.model, body.base, [](const std::string&) { return 0.5; }))
        fuzz::require(pose.matrix().allFinite(), "finite poses");
    if (const auto extent = extentOf(body)) fuzz::require(extent->footprint.size() <= 16, "few corners");
    return 0;
}
