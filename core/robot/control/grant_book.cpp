#include "core/robot/control/grant_book.h"

#include <algorithm>
#include <tuple>

#include "core/event/station_samples.h"

namespace leitstand {
namespace {

using Action = GrantSample::Action;

constexpr std::uint64_t HighestTerm = std::uint64_t{1} << 62U;  // higher ones are nonsense, not terms
constexpr std::size_t MostEntries = 256, MostRequests = 16;     // limits on what others send

}  // namespace

GrantBook::GrantBook(const StationIdentity& me, const Sender& sender, SteadyTime now,
                     const GrantTiming& timing)
    : m_station(me.id), m_title(me.title), m_sender(sender), m_began(now), m_timing(timing) {
    for (const HeldGrant& grant : me.held) {
        Entry* entry = entryOf(grant.id);
        if (entry == nullptr || grant.term == 0 || grant.term > HighestTerm) continue;
        entry->mine = true;
        entry->holder = m_station;
        entry->holderTitle = m_title;
        entry->holderSender = m_sender;
        entry->term = entry->highest = grant.term;
        entry->nextSend = now;
        entry->sent = now - m_timing.silence;  // may act once it has sent a heartbeat
    }
}

GrantBook::Entry* GrantBook::entryOf(const GrantId& id) {
    const auto found = m_entries.find(id);
    if (found != m_entries.end()) return &found->second;
    if (m_entries.size() >= MostEntries) return nullptr;
    return &m_entries[id];
}

void GrantBook::rejoined(const Sender& sender) {
    for (auto& [id, entry] : m_entries) {
        if (entry.mine) entry.holderSender = sender;
    }
    m_sender = sender;
}

void GrantBook::requestGrant(const GrantId& id) {
    Entry* entry = entryOf(id);
    if (entry == nullptr) return;
    entry->refusedBy.clear();
    entry->lostTo.clear();
    if (entry->mine || entry->asked) return;
    entry->asked = true;
    entry->nextSend = {};
}

void GrantBook::giveTo(const GrantId& id, Entry& entry, const std::string& other, SteadyTime now) {
    m_pending.push_back({id, Action::Consent, other, entry.term});
    entry.mine = entry.asked = entry.offered = entry.released = false;
    entry.requests.clear();
    entry.holder = other;
    entry.holderTitle.clear();
    entry.holderSender = {};
    entry.received = now;
}

void GrantBook::release(const GrantId& id, SteadyTime now) {
    Entry* entry = entryOf(id);
    if (entry == nullptr) return;
    entry->asked = entry->offered = false;
    if (!entry->mine) return;
    if (!entry->requests.empty()) {
        const std::string first = entry->requests.front().station;
        return giveTo(id, *entry, first, now);
    }
    m_pending.push_back({id, Action::Release, {}, entry->term});
    entry->mine = false;
    entry->released = true;
    entry->holder.clear();
    entry->holderTitle.clear();
    entry->holderSender = {};
}

void GrantBook::answerRequest(const GrantId& id, bool consent, SteadyTime now) {
    Entry* entry = entryOf(id);
    if (entry == nullptr || !entry->mine || entry->requests.empty()) return;
    const std::string first = entry->requests.front().station;
    if (consent) return giveTo(id, *entry, first, now);
    m_pending.push_back({id, Action::Refuse, first, entry->term});
    entry->requests.erase(entry->requests.begin());
}

void GrantBook::leave(SteadyTime now) {
    for (auto& [id, entry] : m_entries) release(id, now);
}

bool GrantBook::isSilent(const Entry& entry, SteadyTime now) const {
    return !entry.mine && !entry.holder.empty() && now - entry.received >= m_timing.silence;
}

bool GrantBook::mayTake(const Entry& entry, SteadyTime now) const {
    if (entry.offered) return true;
    if (entry.holder.empty()) return entry.released || now - m_began >= m_timing.silence;
    // An earlier run of this station, which did not remember what it held.
    if (entry.holder == m_station && entry.holderSender != Sender{} && entry.holderSender != m_sender)
        return true;
    return isSilent(entry, now);
}

bool GrantBook::beats(const GrantSample& sample, const Sender& from, const Entry& entry) const {
    if (sample.term != entry.term) return sample.term > entry.term;
    return std::tie(sample.station, from) < std::tie(entry.holder, entry.holderSender);
}

void GrantBook::receive(const GrantSample& sample, const Sender& from, SteadyTime now) {
    if (from == m_sender || sample.station.empty() || sample.term > HighestTerm) return;
    const GrantId id{sample.kind, sample.robot};
    Entry* entry = entryOf(id);
    if (entry == nullptr) return;
    if (sample.action == Action::Hold) return receiveHold(id, *entry, sample, from, now);
    receiveWord(*entry, sample, from, now);
}

void GrantBook::receiveHold(const GrantId& id, Entry& entry, const GrantSample& sample, const Sender& from,
                            SteadyTime now) {
    entry.highest = std::max(entry.highest, sample.term);
    const bool same = entry.holder == sample.station;
    if (entry.mine) {
        if (!beats(sample, from, entry)) {
            entry.nextSend = now;  // it shall learn at once that it is wrong
            return;
        }
        giveTo(id, entry, sample.station, now);
        entry.lostTo = sample.station;
    } else if (!same && !entry.holder.empty() && !isSilent(entry, now) && !beats(sample, from, entry)) {
        return;
    }
    entry.holder = sample.station;
    entry.holderTitle = sample.title;
    entry.holderSender = from;
    entry.term = sample.term;
    entry.received = now;
    entry.released = entry.offered = false;
}

void GrantBook::receiveWord(Entry& entry, const GrantSample& sample, const Sender& from, SteadyTime now) {
    const bool fromHolder = !entry.mine && entry.holder == sample.station && entry.holderSender == from;
    switch (sample.action) {
        case Action::Hold:
            return;
        case Action::Request: {
            if (!entry.mine) return;
            const auto known =
                std::find_if(entry.requests.begin(), entry.requests.end(),
                             [&](const Request& one) { return one.station == sample.station; });
            if (known != entry.requests.end()) {
                known->last = now;
            } else if (entry.requests.size() < MostRequests) {
                entry.requests.push_back({sample.station, sample.title, now});
            }
            return;
        }
        case Action::Consent:
            if (!fromHolder && !(entry.holder.empty() && !entry.mine)) return;
            entry.highest = std::max(entry.highest, sample.term);
            if (sample.other == m_station) {
                entry.offered = entry.asked;
                entry.released = true;
                entry.holder.clear();
                entry.holderTitle.clear();
            } else {
                entry.holder = sample.other;  // for 3 s only this station may take it
                entry.holderTitle.clear();
                entry.received = now;
            }
            entry.holderSender = {};
            return;
        case Action::Refuse:
            if (!fromHolder || sample.other != m_station || !entry.asked) return;
            entry.asked = false;
            entry.refusedBy = sample.station;
            return;
        case Action::Release:
            if (!fromHolder) return;
            entry.released = true;
            entry.holder.clear();
            entry.holderTitle.clear();
            entry.holderSender = {};
            return;
    }
}

void GrantBook::take(Entry& entry, SteadyTime now, Time wall) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(wall.time_since_epoch()).count();
    const auto clock = seconds > 0 ? static_cast<std::uint64_t>(seconds) : 1U;
    entry.term = std::min(std::max(entry.highest + 1, clock), HighestTerm);
    entry.highest = entry.term;
    entry.mine = true;
    entry.asked = entry.offered = entry.released = false;
    entry.holder = m_station;
    entry.holderTitle = m_title;
    entry.holderSender = m_sender;
    entry.requests.clear();
    entry.lostTo.clear();
    entry.nextSend = now;
}

std::vector<GrantSample> GrantBook::due(SteadyTime now, Time wall) {
    std::vector<GrantSample> all;
    const auto add = [&](const GrantId& id, Action action, const std::string& other, std::uint64_t term) {
        all.push_back({wall, m_station, m_title, id.kind, action, id.robot, other, term});
    };
    for (const Pending& pending : m_pending) add(pending.id, pending.action, pending.other, pending.term);
    m_pending.clear();
    for (auto& [id, entry] : m_entries) {
        std::erase_if(entry.requests, [&](const Request& one) { return now - one.last >= m_timing.silence; });
        if (entry.asked && mayTake(entry, now)) take(entry, now, wall);
        if (now < entry.nextSend) continue;
        if (entry.mine) {
            add(id, Action::Hold, {}, entry.term);
            entry.sent = now;
        } else if (entry.asked && !entry.holder.empty()) {
            add(id, Action::Request, {}, entry.term);
        } else {
            continue;
        }
        entry.nextSend = now + m_timing.heartbeat;
    }
    return all;
}

GrantView GrantBook::view(const GrantId& id, SteadyTime now) const {
    const auto found = m_entries.find(id);
    if (found == m_entries.end()) return {};
    const Entry& entry = found->second;
    GrantView view;
    view.mine = entry.mine;
    view.asked = entry.asked;
    view.silent = isSilent(entry, now);
    view.holder = entry.holder;
    view.holderTitle = entry.holderTitle;
    view.refusedBy = entry.refusedBy;
    view.lostTo = entry.lostTo;
    if (!entry.requests.empty()) {
        view.requestedBy = entry.requests.front().station;
        view.requestedByTitle = entry.requests.front().title;
    }
    return view;
}

bool GrantBook::mayAct(const GrantId& id, SteadyTime now) const {
    const auto found = m_entries.find(id);
    return found != m_entries.end() && found->second.mine && now - found->second.sent < m_timing.silence;
}

std::vector<HeldGrant> GrantBook::held() const {
    std::vector<HeldGrant> all;
    for (const auto& [id, entry] : m_entries) {
        if (entry.mine) all.push_back({id, entry.term});
    }
    return all;
}

std::vector<GrantId> GrantBook::known() const {
    std::vector<GrantId> all;
    for (const auto& [id, entry] : m_entries) all.push_back(id);
    return all;
}

}  // namespace leitstand
