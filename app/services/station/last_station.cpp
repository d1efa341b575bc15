#include "app/services/station/last_station.h"

#include "core/io/settings/last_station_file.h"

namespace leitstand {

std::optional<LastStation> lastStation(const std::filesystem::path& file) {
    return readLastStation(file);
}

void rememberStation(const std::filesystem::path& file, const LastStation& station) {
    (void)writeLastStation(file, station);
}

}  // namespace leitstand
