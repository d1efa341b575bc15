#include "core/robot/streams/wish_book.h"

namespace leitstand {

void WishBook::change(Entry& entry, const StreamWish& before) {
    if (stricter(entry.own, entry.thin) == before) return;
    entry.left = m_rhythm.times;
    entry.next = {};
}

void WishBook::set(const std::string& topic, const StreamWish& wish) {
    Entry& entry = m_entries[topic];
    const StreamWish before = stricter(entry.own, entry.thin);
    entry.own = wish;
    change(entry, before);
}

void WishBook::setThin(const std::map<std::string, StreamWish>& wishes) {
    for (const auto& [topic, wish] : wishes) m_entries.try_emplace(topic);
    for (auto& [topic, entry] : m_entries) {
        const auto wanted = wishes.find(topic);
        const StreamWish before = stricter(entry.own, entry.thin);
        entry.thin = wanted == wishes.end() ? StreamWish{} : wanted->second;
        change(entry, before);
    }
}

void WishBook::returned() {
    for (auto& [topic, entry] : m_entries) {
        if (stricter(entry.own, entry.thin).isPlain()) continue;
        entry.left = m_rhythm.times;
        entry.next = {};
    }
}

StreamWish WishBook::own(const std::string& topic) const {
    const auto found = m_entries.find(topic);
    return found == m_entries.end() ? StreamWish{} : found->second.own;
}

StreamWish WishBook::effective(const std::string& topic) const {
    const auto found = m_entries.find(topic);
    return found == m_entries.end() ? StreamWish{} : stricter(found->second.own, found->second.thin);
}

std::vector<StreamCommandSample> WishBook::due(SteadyTime now) {
    std::vector<StreamCommandSample> commands;
    for (auto& [topic, entry] : m_entries) {
        const StreamWish wish = stricter(entry.own, entry.thin);
        // A withdrawn wish is the robot's own default: it is sent, and then forgotten.
        if ((entry.left == 0 && wish.isPlain()) || now < entry.next) continue;
        if (entry.left > 0) --entry.left;
        entry.next = now + (entry.left > 0 ? m_rhythm.again : m_rhythm.reminder);
        commands.push_back(commandOf(topic, wish));
    }
    return commands;
}

}  // namespace leitstand
