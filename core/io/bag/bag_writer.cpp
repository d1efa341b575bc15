#include "core/io/bag/bag_writer.h"

#include <utility>

#include <fmt/format.h>

#include "core/io/bag/writing/bag_store.h"
#include "core/io/bag/writing/mission_store.h"
#include "core/io/bag/writing/writer_core.h"

namespace leitstand {

class BagWriter::Impl : public detail::WriterCore {
    using detail::WriterCore::WriterCore;
};

BagWriter::BagWriter(std::unique_ptr<Impl> impl) : m_impl(std::move(impl)) {}

BagWriter::~BagWriter() {
    (void)close();
}

Result<std::unique_ptr<BagWriter>> BagWriter::open(const std::filesystem::path& mission,
                                                   const BagWriterSettings& settings, AlarmHandler onAlarm) {
    auto store = detail::createStore(mission, settings.storage);
    if (!store) return store.error();
    return over(std::move(store).value(), settings, std::move(onAlarm));
}

std::unique_ptr<BagWriter> BagWriter::over(std::unique_ptr<detail::BagStore> store,
                                           const BagWriterSettings& settings, AlarmHandler onAlarm) {
    return std::unique_ptr<BagWriter>(
        new BagWriter(std::make_unique<Impl>(std::move(store), settings, std::move(onAlarm))));
}

void BagWriter::addTopic(const TopicInfo& topic) {
    m_impl->addTopic(topic);
}

void BagWriter::write(RawEvent event) {
    m_impl->write(std::move(event));
}

BagWriterStatistics BagWriter::statistics() const {
    return m_impl->statistics();
}

const std::filesystem::path& BagWriter::file() const {
    return m_impl->store().file();
}

std::uint64_t BagWriter::earlierSequence() const {
    return m_impl->store().earlierSequence();
}

Result<void> BagWriter::flush(std::chrono::milliseconds deadline) {
    return m_impl->flush(deadline);
}

Result<void> BagWriter::close() {
    return m_impl->close();
}

}  // namespace leitstand
