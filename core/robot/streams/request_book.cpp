#include "core/robot/streams/request_book.h"

namespace leitstand {

void RequestBook::change(Entry& entry, const StreamRequest& before) {
    if (stricter(entry.own, entry.thin) == before) return;
    entry.left = m_rhythm.times;
    entry.next = {};
}

void RequestBook::set(const std::string& topic, const StreamRequest& request) {
    Entry& entry = m_entries[topic];
    const StreamRequest before = stricter(entry.own, entry.thin);
    entry.own = request;
    change(entry, before);
}

void RequestBook::setThin(const std::map<std::string, StreamRequest>& requests) {
    for (const auto& [topic, request] : requests) m_entries.try_emplace(topic);
    for (auto& [topic, entry] : m_entries) {
        const auto wanted = requests.find(topic);
        const StreamRequest before = stricter(entry.own, entry.thin);
        entry.thin = wanted == requests.end() ? StreamRequest{} : wanted->second;
        change(entry, before);
    }
}

void RequestBook::returned() {
    for (auto& [topic, entry] : m_entries) {
        if (stricter(entry.own, entry.thin).isPlain()) continue;
        entry.left = m_rhythm.times;
        entry.next = {};
    }
}

StreamRequest RequestBook::own(const std::string& topic) const {
    const auto found = m_entries.find(topic);
    return found == m_entries.end() ? StreamRequest{} : found->second.own;
}

StreamRequest RequestBook::effective(const std::string& topic) const {
    const auto found = m_entries.find(topic);
    return found == m_entries.end() ? StreamRequest{} : stricter(found->second.own, found->second.thin);
}

std::vector<StreamCommandSample> RequestBook::due(SteadyTime now) {
    std::vector<StreamCommandSample> commands;
    for (auto& [topic, entry] : m_entries) {
        const StreamRequest request = stricter(entry.own, entry.thin);
        // A withdrawn wish is the robot's own default: it is sent, and then forgotten.
        if ((entry.left == 0 && request.isPlain()) || now < entry.next) continue;
        if (entry.left > 0) --entry.left;
        entry.next = now + (entry.left > 0 ? m_rhythm.again : m_rhythm.reminder);
        commands.push_back(commandOf(topic, request));
    }
    return commands;
}

}  // namespace leitstand
