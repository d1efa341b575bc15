#pragma once

#include <functional>
#include <string>
#include <utility>

#include "app/services/job_queue.h"
#include "app/services/mapping/live_mapping_listener.h"
#include "core/mapping/live/live_mapper.h"

namespace leitstand {

/// What LiveMapping and its parts share. On the mapping's thread, unless a member says otherwise.
struct MappingContext {
    using Post = std::function<void(std::function<void(LiveMapper&)>)>;
    MappingContext(const std::string& station, LiveSettings how, LiveMappingListener listening, Post posting)
        : listener(std::move(listening)),
          settings(std::move(how)),
          post(std::move(posting)),
          mapper(station, settings),
          crop(settings.crop) {}

    const LiveMappingListener listener;
    const LiveSettings settings;  ///< any thread
    /// Runs a task with the mapper on the mapping's thread, after waiting work. Then the map is published as
    /// changed. Any thread.
    const Post post;
    LiveMapper mapper;
    LiveMapPtr map;    ///< newest map; null before there is one
    MapCrop crop;      ///< the area that belongs to the map
    JobQueue solving;  ///< jobs of the solver's thread; any thread

    /// Whether this station makes the map, so that its poses of scans are valid.
    [[nodiscard]] bool makesMap() const { return !listener.makesMap || listener.makesMap(); }
};

}  // namespace leitstand
