#include "core/handin/file_names.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace leitstand {
namespace {

constexpr std::size_t Longest = 60;

/// Umlauts and how they are spelled out.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> Spelled = {
    {{"ä", "ae"}, {"ö", "oe"}, {"ü", "ue"}, {"Ä", "Ae"}, {"Ö", "Oe"}, {"Ü", "Ue"}, {"ß", "ss"}}};

bool plain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '.';
}

}  // namespace

std::string fileNamePart(std::string_view text) {
    std::string name;
    while (!text.empty() && name.size() < Longest) {
        bool spelled = false;
        for (const auto& [letter, written] : Spelled) {
            if (!text.starts_with(letter)) continue;
            name += written;
            text.remove_prefix(letter.size());
            spelled = true;
            break;
        }
        if (spelled) continue;
        const char letter = text.front();
        text.remove_prefix(1);
        if (plain(letter)) {
            name += letter;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    // Avoids hidden files, "..", and a dot at the end, which Windows removes.
    while (!name.empty() && (name.front() == '.' || name.front() == '_')) name.erase(0, 1);
    while (!name.empty() && (name.back() == '.' || name.back() == '_')) name.pop_back();
    return name;
}

std::vector<std::string> fileNameParts(const std::vector<std::string>& names) {
    std::vector<std::string> parts;
    std::set<std::string> taken;  // in small letters
    const auto take = [&taken](std::string part) {
        std::transform(part.begin(), part.end(), part.begin(), [](char letter) {
            return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
        });
        return taken.insert(std::move(part)).second;
    };
    for (const std::string& name : names) {
        std::string plainName = fileNamePart(name);
        if (plainName.empty()) plainName = "robot";
        std::string part = plainName;
        for (int number = 2; !take(part); ++number) part = plainName + "_" + std::to_string(number);
        parts.push_back(std::move(part));
    }
    return parts;
}

std::string handInName(std::string_view competition, std::string_view team, std::string_view mission) {
    const auto part = [](std::string_view text, std::string_view otherwise) {
        std::string name = fileNamePart(text);
        return name.empty() ? std::string(otherwise) : name;
    };
    return part(competition, "Competition") + "-" + part(team, "Team") + "-" + part(mission, "Mission");
}

}  // namespace leitstand
