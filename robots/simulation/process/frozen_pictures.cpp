#include "robots/simulation/process/frozen_pictures.h"

#include <variant>

namespace leitstand::simulation {

void FrozenPictures::pass(HardwareSample& sample, bool frozen) {
    auto* const picture = std::get_if<PictureSample>(&sample.sample);
    if (picture == nullptr || sample.role != StreamRole::Picture) return;
    const auto [last, first] = m_last.try_emplace(sample.sensor, *picture);
    if (first) return;
    if (!frozen) {
        last->second = *picture;
        return;
    }
    const SampleHeader header = picture->header;
    *picture = last->second;
    picture->header = header;
}

}  // namespace leitstand::simulation
