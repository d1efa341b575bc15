#include "core/station/frames/frame_tree.h"

#include <chrono>
#include <set>
#include <utility>

#include "core/event/event.h"
#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds DisputeLasts{5};
constexpr double Smoothing = 0.1;  ///< weight of the newest interval in the rate

/// Takes one more transform of @p node, received at @p now.
void count(FrameNode& node, Time now) {
    const double since = toSeconds(now - node.received);
    if (since <= 0.0) return;
    const double present = 1.0 / since;
    // A pause is no slow rate: the age shows it.
    constexpr double Pause = 2.0;  // [s]
    if (node.rate == 0.0 || since > Pause) {
        node.rate = since > Pause ? 0.0 : present;
    } else {
        node.rate = 1.0 / ((1.0 - Smoothing) / node.rate + Smoothing * since);
    }
}

}  // namespace

bool FrameTree::makeRoom() {
    if (m_nodes.size() < MostFrames) return true;
    auto oldest = m_nodes.end();
    for (auto node = m_nodes.begin(); node != m_nodes.end(); ++node) {
        const bool older = oldest == m_nodes.end() || node->second.received < oldest->second.received;
        if (!node->second.fixed && older) oldest = node;
    }
    if (oldest == m_nodes.end()) return false;
    m_nodes.erase(oldest);
    return true;
}

void FrameTree::take(const FrameTransform& one, const Event& event) {
    constexpr std::size_t MostOthers = 8;
    if (one.childFrame.size() > LongestName || one.header.frame.size() > LongestName) return;
    auto found = m_nodes.find(one.childFrame);
    const bool isNew = found == m_nodes.end();
    if (isNew && !makeRoom()) return;
    if (isNew) found = m_nodes.try_emplace(one.childFrame).first;
    FrameNode& node = found->second;
    const bool fixed = event.role == StreamRole::StaticTransforms;
    if (!isNew && node.parent != one.header.frame && node.others.size() < MostOthers)
        node.others[node.parent] = {node.received, node.fixed};
    node.others.erase(one.header.frame);
    if (fixed)
        node.rate = 0.0;
    else if (!isNew)
        count(node, event.received);
    node.frame = one.childFrame;
    node.parent = one.header.frame;
    node.topic = event.topic;
    node.fixed = fixed;
    node.received = event.received;
    node.frameInParent = one.childInParent;
}

void FrameTree::take(const Event& event) {
    const auto* const transforms = event.sample.as<TransformsSample>();
    if (transforms == nullptr) return;
    for (const FrameTransform& one : transforms->transforms) take(one, event);
}

std::vector<FrameRow> FrameTree::rows(Time now) const {
    std::map<std::string, std::vector<const FrameNode*>> below;
    for (const auto& [name, node] : m_nodes) below[node.parent].push_back(&node);
    std::vector<FrameRow> rows;
    std::set<std::string> shown;
    const auto rowOf = [&](const FrameNode& node, int depth) {
        FrameRow row;
        row.node = node;
        row.depth = depth;
        for (const auto& [parent, other] : node.others)
            if (other.fixed || now - other.received <= DisputeLasts) row.otherParent = parent;
        return row;
    };
    // A stack, not a recursion: a hostile robot may send a chain of any length.
    const auto addBelow = [&](const std::string& root) {
        std::vector<std::pair<const FrameNode*, int>> next;
        const auto push = [&](const std::string& parent, int depth) {
            const auto found = below.find(parent);
            if (found == below.end()) return;
            for (auto child = found->second.rbegin(); child != found->second.rend(); ++child)
                next.emplace_back(*child, depth);
        };
        push(root, 1);
        while (!next.empty()) {
            const auto [node, depth] = next.back();
            next.pop_back();
            if (!shown.insert(node->frame).second) continue;
            rows.push_back(rowOf(*node, depth));
            push(node->frame, depth + 1);
        }
    };
    for (const auto& [parent, children] : below) {
        if (m_nodes.contains(parent)) continue;
        FrameRow root;
        root.node.frame = parent;
        root.root = true;
        rows.push_back(std::move(root));
        addBelow(parent);
    }
    // What no root reaches lies in a circle, or below one.
    for (const auto& [name, node] : m_nodes) {
        if (shown.contains(name)) continue;
        shown.insert(name);
        FrameRow row = rowOf(node, 0);
        row.circle = true;
        rows.push_back(std::move(row));
        addBelow(name);
    }
    return rows;
}

std::string FrameTree::rootOf(const std::string& frame) const {
    std::string at = frame;
    for (std::size_t steps = 0; steps <= m_nodes.size(); ++steps) {
        const auto found = m_nodes.find(at);
        if (found == m_nodes.end()) return at;
        at = found->second.parent;
    }
    return {};  // a circle
}

bool FrameTree::connects(const std::string& frame, const std::string& other) const {
    if (frame == other) return true;
    const std::string root = rootOf(frame);
    return !root.empty() && root == rootOf(other);
}

}  // namespace leitstand
