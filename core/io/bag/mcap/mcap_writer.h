#pragma once

#include <filesystem>
#include <utility>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/io/bag/mcap/mcap_encoder.h"
#include "core/io/bag/topic_info.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

/// Writes an MCAP file, which appears whole or not at all. One thread.
class McapWriter {
public:
    using Sequences = detail::McapEncoder::Sequences;

    /// Begins @p file. Error when it cannot be written.
    [[nodiscard]] static Result<McapWriter> create(const std::filesystem::path& file, Sequences sequences);
    McapWriter(McapWriter&&) noexcept = default;

    /// Adds a message of @p topic; see detail::McapEncoder::add().
    void write(const TopicInfo& topic, const RawEvent& event);
    /// Writes what is left, and the summary. Error: the disk failed at any time, or there are more than
    /// 65,535 topics.
    [[nodiscard]] Result<void> close();

private:
    McapWriter(detail::OutputFile file, Sequences sequences)
        : m_file(std::move(file)), m_encoder(sequences) {}

    detail::OutputFile m_file;
    detail::McapEncoder m_encoder;
};

}  // namespace leitstand
