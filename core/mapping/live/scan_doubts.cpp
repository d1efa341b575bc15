#include "core/mapping/live/scan_doubts.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/event/map_samples.h"

namespace leitstand {

std::string inWords(std::uint8_t doubts) {
    constexpr std::array<std::pair<ScanDoubt, const char*>, 8> Words = {
        {{ScanDoubt::Points, "too few points"},
         {ScanDoubt::Odometry, "no odometry"},
         {ScanDoubt::Overlap, "little overlap with the map"},
         {ScanDoubt::Residual, "a bad fit"},
         {ScanDoubt::Jump, "a jump against the odometry"},
         {ScanDoubt::Certainty, "an open direction"},
         {ScanDoubt::Diverged, "the registration came to no end"},
         {ScanDoubt::Guessed, "motion partly guessed"}}};
    std::string text;
    for (const auto& [doubt, word] : Words) {
        if (!has(doubts, doubt)) continue;
        if (!text.empty()) text += ", ";
        text += word;
    }
    return text;
}

double certaintyOf(double overlap, double certainty) {
    constexpr double PlentyOverlap = 0.8, PlentyCertainty = 0.1;  // more of it makes no pose any surer
    return std::clamp(overlap / PlentyOverlap, 0.0, 1.0) * std::clamp(certainty / PlentyCertainty, 0.0, 1.0);
}

}  // namespace leitstand
