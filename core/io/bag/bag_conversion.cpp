#include "core/io/bag/bag_conversion.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <system_error>
#include <utility>

#include "core/base/words.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/bag_writer.h"
#include "core/io/bag/detail/bag_metadata.h"
#include "core/io/bag/mcap/mcap_writer.h"
#include "core/io/bag/raw_events.h"
#include "core/io/detail/output_file.h"
#include "core/io/detail/unfinished.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t EventsAFlush = 200;
constexpr std::size_t BytesAFlush = 32U << 20U;
constexpr std::chrono::seconds Longest(60);  ///< that a disk may take for so many

using Topics = std::map<std::pair<std::string, std::string>, TopicInfo>;  ///< by name and type

Topics topicsOf(const BagReader& bag) {
    Topics topics;
    for (const BagTopic& topic : bag.topics()) topics[{topic.info.name, topic.info.type}] = topic.info;
    return topics;
}

/// Writes the metadata.yaml of an MCAP bag of one file.
Result<void> writeMetadata(const fs::path& folder, const std::string& file, BagReader& bag,
                           const std::map<std::string, std::uint64_t>& counts) {
    detail::BagMetadata metadata;
    metadata.storage = "mcap";
    std::uint64_t messages = 0;
    for (const BagTopic& topic : bag.topics()) {
        const auto counted = counts.find(topic.info.name + " " + topic.info.type);
        metadata.topics.push_back({topic.info, counted == counts.end() ? 0 : counted->second});
        messages += metadata.topics.back().messages;
    }
    metadata.files.push_back({file, bag.first(), bag.last(), messages});
    if (bag.ours())  // a mission, which can be gone on with
        metadata.custom[std::string(detail::CountedKey)] = std::to_string(bag.lastSequence());
    return detail::writeWhole(folder / "metadata.yaml", detail::yamlOf(metadata, false));
}

Result<std::uint64_t> writeMcap(BagReader& bag, const fs::path& folder, const std::string& name,
                                const Progress& progress) {
    const std::string file = name + "_0.mcap";
    auto created = McapWriter::create(
        folder / file, bag.ours() ? McapWriter::Sequences::Kept : McapWriter::Sequences::Dropped);
    if (!created) return created.error();
    McapWriter writer = std::move(created).value();
    const Topics topics = topicsOf(bag);
    std::map<std::string, std::uint64_t> counts;  // by topic and type
    std::uint64_t messages = 0;
    forEachRaw(
        bag, {},
        [&](const RawEvent& event) {
            const auto topic = topics.find({event.topic, event.type});
            if (topic == topics.end()) return true;  // of a damaged file, which says so
            writer.write(topic->second, event);
            ++counts[event.topic + " " + event.type];
            ++messages;
            return true;
        },
        progress);
    if (const auto closed = writer.close(); !closed) return closed.error();
    if (const auto written = writeMetadata(folder, file, bag, counts); !written) return written.error();
    return messages;
}

Result<std::uint64_t> writeDatabase(BagReader& bag, const fs::path& folder, const Progress& progress) {
    auto writer = BagWriter::open(folder, {.storage = BagStorage::Sqlite});
    if (!writer) return writer.error();
    for (const auto& [key, topic] : topicsOf(bag)) (*writer)->addTopic(topic);
    const bool ours = bag.ours();
    std::uint64_t messages = 0;
    std::size_t bytes = 0;  // since the last flush
    Result<void> flushed;
    forEachRaw(
        bag, {},
        [&](RawEvent& event) {
            if (!ours) event.sequence = 0;  // of several files, they may not rise
            bytes += event.cdr->size();
            (*writer)->write(std::move(event));
            ++messages;
            // What is read faster than it is written would wait in memory.
            if (bytes < BytesAFlush && messages % EventsAFlush != 0) return true;
            bytes = 0;
            flushed = (*writer)->flush(Longest);
            return flushed.ok();
        },
        progress);
    if (!flushed) return flushed.error();
    if (const auto closed = (*writer)->close(); !closed) return closed.error();
    if (const auto dropped = (*writer)->statistics().dropped; !dropped.empty())
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: is not written: messages of {} were dropped"),
                            folder.string(), dropped.begin()->first)};
    return messages;
}

/// Copies what stands in the folder of @p bag beside its log.
Result<void> copyBeside(const fs::path& bag, const fs::path& folder) {
    for (const char* name : {"robots", "snapshots"}) {
        std::error_code problem;
        if (!fs::is_directory(bag / name, problem)) continue;
        fs::copy(bag / name, folder / name, fs::copy_options::recursive, problem);
        if (problem)
            return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be copied: {}"),
                                         (bag / name).string(), problem.message())};
    }
    return {};
}

}  // namespace

bool isCopyOfMission(const BagReader& bag) {
    return !bag.ours() && std::any_of(bag.topics().begin(), bag.topics().end(), [](const BagTopic& topic) {
        return topic.info.name.starts_with(station_topic::Prefix);
    });
}

Result<BagConversion> convertBag(const fs::path& bag, const fs::path& out, BagStorage storage,
                                 const Progress& progress) {
    auto reader = BagReader::open(bag);
    if (!reader) return reader.error();
    BagReader& source = **reader;
    if (storage == BagStorage::Sqlite && isCopyOfMission(source))
        return Error{leitstand::fill(
            translate(
                "leitstand::Error",
                "{}: is a copy of a mission in MCAP, without the numbers by which finds name their evidence: "
                "expected the mission itself"),
            bag.string())};
    std::error_code problem;
    if (fs::exists(out, problem))
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a folder that does not exist yet"), out.string())};
    const fs::path whole = fs::weakly_canonical(out, problem), from = fs::weakly_canonical(bag, problem);
    if (std::mismatch(from.begin(), from.end(), whole.begin(), whole.end()).first == from.end())
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected a folder outside of the bag"), out.string())};
    detail::Unfinished unfinished(out);  // destroyed after the writer has closed its files
    fs::create_directories(out, problem);
    if (problem)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be made: {}"), out.string(),
                                     problem.message())};
    const std::string name = (whole.has_filename() ? whole : whole.parent_path()).filename().string();
    const auto written = storage == BagStorage::Mcap ? writeMcap(source, out, name, progress)
                                                     : writeDatabase(source, out, progress);
    if (!written) return written.error();
    if (progress.cancelled())
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: is not written: cancelled"), out.string())};
    if (const auto copied = copyBeside(bag, out); !copied) return copied.error();
    unfinished.done();
    return BagConversion{*written, source.problems()};
}

}  // namespace leitstand
