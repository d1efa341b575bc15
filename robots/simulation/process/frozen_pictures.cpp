#include "robots/simulation/process/frozen_pictures.h"

#include "core/event/stream_role.h"

namespace leitstand::simulation {

void FrozenPictures::pass(HardwareSample& sample, bool frozen) {
    if (sample.role != StreamRole::Picture) return;
    auto* const picture = sample.sample.edit<PictureSample>();
    if (picture == nullptr) return;
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
