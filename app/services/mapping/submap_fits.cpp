#include "app/services/mapping/submap_fits.h"

#include <utility>

namespace leitstand {

SubmapFits::SubmapFits() {
    m_thread = std::jthread([this](const std::stop_token& stop) { m_jobs.work(stop); });
}

SubmapFits::~SubmapFits() {
    m_jobs.cancel();
}

void SubmapFits::begin(LiveMapPtr map, std::set<std::uint64_t> submap, std::set<std::uint64_t> left) {
    end();
    const std::lock_guard lock(m_mutex);
    m_jobs.submit([this, run = m_run, map = std::move(map), submap = std::move(submap),
                   left = std::move(left)](const std::stop_token& stop) mutable {
        auto made =
            std::make_shared<const SubmapOnMap>(std::move(map), std::move(submap), left, Progress{{}, stop});
        const std::lock_guard done(m_mutex);
        if (stop.stop_requested() || !counts(run)) return;
        m_submap = std::move(made);
        work();
    });
}

void SubmapFits::end() {
    m_jobs.cancel();
    const std::lock_guard lock(m_mutex);
    ++m_run;
    m_submap.reset();
    m_wanted.reset();
    m_fit.reset();
    m_snapped.reset();
    m_works = false;
}

void SubmapFits::want(const Pose& moved) {
    const std::lock_guard lock(m_mutex);
    m_wanted = moved;
    work();
}

void SubmapFits::work() {
    if (m_works || !m_submap || !m_wanted) return;
    m_works = true;
    m_jobs.submit([this, run = m_run, submap = m_submap](const std::stop_token&) {
        std::optional<Pose> moved;
        {
            const std::lock_guard lock(m_mutex);
            if (counts(run)) moved = std::exchange(m_wanted, std::nullopt);
        }
        if (!moved) return;
        const SubmapFit fit = submap->at(*moved);
        const std::lock_guard done(m_mutex);
        if (!counts(run)) return;
        m_fit = fit;
        m_works = false;
        work();
    });
}

void SubmapFits::snap(const Pose& moved) {
    const std::lock_guard lock(m_mutex);
    if (!m_submap) return;
    m_jobs.submit([this, run = m_run, submap = m_submap, moved](const std::stop_token& stop) {
        const auto found = submap->snapped(moved, Progress{{}, stop});
        const std::lock_guard done(m_mutex);
        if (!stop.stop_requested() && counts(run)) m_snapped = Snapped{found};
    });
}

SubmapOnMapPtr SubmapFits::submap() const {
    const std::lock_guard lock(m_mutex);
    return m_submap;
}

std::optional<SubmapFit> SubmapFits::fit() const {
    const std::lock_guard lock(m_mutex);
    return m_fit;
}

std::optional<SubmapFits::Snapped> SubmapFits::takeSnapped() {
    const std::lock_guard lock(m_mutex);
    return std::exchange(m_snapped, std::nullopt);
}

}  // namespace leitstand
