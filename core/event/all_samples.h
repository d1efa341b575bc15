#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "core/event/candidate_sample.h"
#include "core/event/cloud_sample.h"
#include "core/event/command_samples.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/event/status_samples.h"

namespace leitstand {
namespace detail {

template <class Returned, class Visitor, class... Types>
constexpr bool allReturn(TypeList<Types...> /*types*/) {
    return (std::is_same_v<Returned, std::invoke_result_t<Visitor&, const Types&>> && ...);
}

template <class Returned, class Visitor, class Given, class... Types>
Returned visitOneOf(TypeList<Types...> /*types*/, Visitor& visitor, Given& sample) {
    static_assert((requires { sizeof(Types); } && ...), "each of SampleTypes has its header here");
    using Call = Returned (*)(Visitor&, Given&);
    static constexpr std::array<Call, sizeof...(Types)> Calls = {[](Visitor& one, Given& given) -> Returned {
        if constexpr (std::is_const_v<Given>) {
            return one(given.template get<Types>());
        } else {
            return one(*given.template edit<Types>());
        }
    }...};
    if (sample.index() >= Calls.size()) throw std::logic_error("a sample is visited that has no content");
    return Calls[sample.index()](visitor, sample);
}

}  // namespace detail

/// Calls @p visitor with the content of @p sample and returns the visitor's result, whose type must be the
/// same for all contents. Throws std::logic_error when there is no content.
template <class Visitor>
decltype(auto) visit(Visitor&& visitor, const Sample& sample) {
    using Returned = std::invoke_result_t<Visitor&, const OdometrySample&>;
    static_assert(detail::allReturn<Returned, Visitor>(SampleTypes()), "a visitor returns one type");
    return detail::visitOneOf<Returned>(SampleTypes(), visitor, sample);
}
/// Calls @p visitor with the content of @p sample, which the visitor may change. Throws as visit() does.
template <class Visitor>
void edit(Visitor&& visitor, Sample& sample) {
    detail::visitOneOf<void>(SampleTypes(), visitor, sample);
}

}  // namespace leitstand
