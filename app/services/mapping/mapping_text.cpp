#include "app/services/mapping/mapping_text.h"

#include <cmath>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/mapping/placement/placement_format.h"

namespace leitstand::mapping_words {
namespace {

/// Returns the outcome of looking for the robot; empty: the reason already holds it.
std::string outcomeOf(const RobotPlaceSample& place) {
    using Cause = RobotPlaceSample::Cause;
    const bool put = placement_format::isPhrase(place.how, placement_format::PutUntilScan);
    if (put || placement_format::isPhrase(place.how, placement_format::FoundByScan)) return {};
    if (place.cause == Cause::Tracked)
        return place.certain ? translate("leitstand::Station", "its laser fits the map again")
                             : translate("leitstand::Station", "its place in the map is doubted");
    if (place.certain) return translate("leitstand::Station", "found in the map");
    if (place.cause != Cause::Slot) return translate("leitstand::Station", "not found there");
    return translate(
        "leitstand::Station",
        "not found beside the other robot: put it to where it stands, or let the other one see it");
}

}  // namespace

std::string question() {
    return translate(
        "leitstand::Station",
        "is this a place that was seen before? The map is farther off here than expected: say whether "
        "it is the same place");
}

std::string partsMeet() {
    return translate("leitstand::Station",
                     "two parts of the map seem to have seen the same place: say whether they did");
}

std::string met(double largest) {
    return fill(translate("leitstand::Station", "the map meets itself: its parts moved by up to {} m"),
                fmt::format("{:.2f}", largest));
}

std::string contradicted() {
    return translate("leitstand::Station",
                     "a closed loop contradicts the rest of the map: it does not count any more");
}

std::string place(const std::string& title, const RobotPlaceSample& place) {
    const std::string how = placement_format::inWindowsLanguage(place.how), what = outcomeOf(place);
    return what.empty() ? fmt::format("{}: {}", title, how) : fmt::format("{}: {}: {}", title, what, how);
}

std::string lookedFor(const std::string& title, std::size_t alike) {
    const std::string what =
        alike > 1
            ? fill(translate("leitstand::Station",
                             "{} places of the map look like where it is: put it to where it stands"),
                   alike)
            : translate("leitstand::Station",
                        "no place of the map fits its newest 3D scan for sure: put it to where it stands");
    return fmt::format("{}: {}", title, what);
}

std::string scannerIsOff(const std::string& title) {
    return fill(translate("leitstand::Station",
                          "{}: what its 3D scanner measures does not fit together: say whether it is to be "
                          "corrected"),
                title);
}

std::string mapsByLaser(const std::string& title, const std::string& topic) {
    return leitstand::fill(translate("leitstand::Station", "{}: its plane laser {} makes the map"), title,
                           topic);
}

std::string mapsWith(const std::string& title, const std::string& topic) {
    return leitstand::fill(
        translate("leitstand::Station",
                  "{}: its map is made from {}; its other clouds are shown, and used for obstacles"),
        title, topic);
}

std::string scannerCorrected(const std::string& title, const std::string& file) {
    const std::string what =
        fill(translate("leitstand::Station", "{}: its 3D scanner is corrected from its next scan on"), title);
    if (file.empty()) return what;
    return what + fill(translate("leitstand::Station", ", and from now on by its file {}"), file);
}

}  // namespace leitstand::mapping_words
