#include "core/base/simd.h"

#include <cstdlib>
#include <string_view>

namespace leitstand {
namespace {

SimdLevel detected() {
    const char* requested = std::getenv("LEITSTAND_SIMD");
    if (requested != nullptr && std::string_view(requested) == "plain") return SimdLevel::Plain;
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return SimdLevel::Avx2;
#endif
    return SimdLevel::Plain;
}

}  // namespace

SimdLevel simdLevel() {
    static const SimdLevel level = detected();
    return level;
}

}  // namespace leitstand
