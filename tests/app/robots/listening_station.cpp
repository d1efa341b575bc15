#include "tests/app/robots/listening_station.h"

#include <algorithm>
#include <sstream>

#include "tests/support/places.h"

namespace leitstand::test {
namespace {

constexpr const char* End = "told\n";

std::vector<std::string> wordsFor(const std::filesystem::path& folder, const TestDomain& domain,
                                  const std::vector<std::string>& more) {
    std::filesystem::create_directories(folder);
    std::vector<std::string> words = {folder.string(), std::to_string(domain.number())};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace

ListeningStation::ListeningStation(const std::filesystem::path& folder, const TestDomain& domain,
                                   std::vector<std::string> more)
    : m_process(program("listening_station"), wordsFor(folder, domain, more)) {}

std::string ListeningStation::reported() const {
    const std::string out = m_process.out();
    const auto end = out.rfind(End);
    if (end == std::string::npos || end == 0) return {};
    const auto before = out.rfind(End, end - 1);
    return out.substr(before == std::string::npos ? 0 : before,
                      end - (before == std::string::npos ? 0 : before));
}

std::string ListeningStation::state(const std::string& robot) const {
    const std::string all = reported(), begin = "link " + robot + " ";
    const auto at = all.find(begin);
    if (at == std::string::npos) return {};
    return all.substr(at + begin.size(), all.find('\n', at) - at - begin.size());
}

std::map<std::string, HeardStream> ListeningStation::streams() const {
    std::map<std::string, HeardStream> all;
    std::istringstream lines(reported());
    for (std::string word, topic; lines >> word;) {
        HeardStream one;
        if (word == "stream" && lines >> topic >> one.arrived >> one.lost >> one.rate) all[topic] = one;
    }
    return all;
}

bool ListeningStation::receives(const std::vector<std::string>& topics) const {
    const auto all = streams();
    return std::all_of(topics.begin(), topics.end(), [&](const std::string& topic) {
        const auto found = all.find(topic);
        return found != all.end() && found->second.arrived > 0;
    });
}

int ListeningStation::end(int number) {
    m_process.signal(number);
    return m_process.wait();
}

}  // namespace leitstand::test
