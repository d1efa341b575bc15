#include "core/io/bag/mcap/mcap_sequences.h"

#include <algorithm>
#include <limits>
#include <string_view>

#include "core/io/bag/mcap/mcap_output.h"
#include "core/io/bag/mcap/mcap_records.h"
#include "core/io/bag/reading/bag_file.h"

namespace leitstand::detail {
namespace {

constexpr std::string_view Name = "leitstand.sequences";

}  // namespace

void McapSequences::add(std::uint64_t sequence) {
    ++m_count;
    const bool follows = !m_runs.empty() && sequence == m_runs.back().first + m_runs.back().count &&
                         m_runs.back().count < std::numeric_limits<std::uint32_t>::max();
    if (follows) {
        ++m_runs.back().count;
    } else {
        m_runs.push_back({sequence, 1});
    }
}

void McapSequences::add(const McapSequences& other) {
    for (const Run& run : other.m_runs) {
        const bool follows = !m_runs.empty() && run.first == m_runs.back().first + m_runs.back().count &&
                             run.count <= std::numeric_limits<std::uint32_t>::max() - m_runs.back().count;
        if (follows) {
            m_runs.back().count += run.count;
        } else {
            m_runs.push_back(run);
        }
    }
    m_count += other.m_count;
}

std::vector<std::uint64_t> McapSequences::first(std::size_t most) const {
    std::vector<std::uint64_t> sequences;
    sequences.reserve(std::min(most, m_count));
    for (const Run& run : m_runs) {
        for (std::uint32_t i = 0; i < run.count && sequences.size() < most; ++i)
            sequences.push_back(run.first + i);
    }
    return sequences;
}

std::string McapSequences::content() const {
    std::string content;
    addText(content, Name);
    for (const Run& run : m_runs) {
        add64(content, run.first);
        add32(content, run.count);
    }
    return content;
}

std::optional<McapSequences> McapSequences::parse(std::span<const std::byte> content, std::size_t most) {
    McapFields fields(content);
    if (fields.text() != Name || !fields.ok()) return std::nullopt;
    McapSequences sequences;
    while (!fields.rest().empty()) {
        Run run;
        run.first = fields.u64();
        run.count = fields.u32();
        const bool sane = fields.ok() && run.count > 0 && run.first > 0 && run.first <= MaxId &&
                          run.count <= MaxId - run.first + 1 && run.count <= most - sequences.m_count;
        if (!sane) return std::nullopt;
        sequences.m_runs.push_back(run);
        sequences.m_count += run.count;
    }
    return sequences;
}

}  // namespace leitstand::detail
