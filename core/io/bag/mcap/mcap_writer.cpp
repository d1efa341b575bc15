#include "core/io/bag/mcap/mcap_writer.h"

#include "core/base/words.h"

namespace leitstand {

Result<McapWriter> McapWriter::create(const std::filesystem::path& file, Sequences sequences) {
    auto opened = detail::OutputFile::create(file);
    if (!opened) return opened.error();
    return McapWriter(std::move(opened).value(), sequences);
}

void McapWriter::write(const TopicInfo& topic, const RawEvent& event) {
    m_encoder.add(topic, event);
    if (m_encoder.hasBytes()) m_file.write(m_encoder.take());
}

Result<void> McapWriter::close() {
    m_encoder.endFile();
    m_file.write(m_encoder.take());
    if (m_encoder.hasTooManyTopics())
        return Error{leitstand::fill(translate("leitstand::Error", "expected at most {} topics"),
                                     detail::McapEncoder::MostTopics)};
    return m_file.commit();
}

}  // namespace leitstand
