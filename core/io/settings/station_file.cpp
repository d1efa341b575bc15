#include "core/io/settings/station_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include "core/event/station_samples.h"

namespace leitstand {
namespace {

using Kind = GrantSample::Kind;

constexpr std::pair<const char*, Kind> Kinds[] = {
    {"drive", Kind::Drive}, {"camera", Kind::Camera}, {"map", Kind::Map}};
constexpr std::size_t MostGrants = 256, LongestName = 64;
constexpr std::size_t LargestFile = 1 << 20;

std::string textOf(const StationIdentity& station) {
    YAML::Emitter out;
    out << YAML::Comment("Identity of this station of Leitstand. Never copy it to another computer.");
    out << YAML::BeginMap << YAML::Key << "station" << YAML::Value << station.id;
    out << YAML::Key << "grants" << YAML::Value << YAML::BeginSeq;
    for (const HeldGrant& grant : station.held) {
        const auto* kind = std::find_if(std::begin(Kinds), std::end(Kinds),
                                        [&](const auto& one) { return one.second == grant.id.kind; });
        out << YAML::Flow << YAML::BeginMap << YAML::Key << "kind" << YAML::Value << kind->first << YAML::Key
            << "robot" << YAML::Value << YAML::DoubleQuoted << grant.id.robot << YAML::Key << "term"
            << YAML::Value << grant.term << YAML::EndMap;
    }
    out << YAML::EndSeq << YAML::EndMap << YAML::Newline;
    return out.c_str();
}

std::optional<HeldGrant> grantOf(const YAML::Node& node) {
    const auto word = node["kind"].as<std::string>();
    const auto* kind =
        std::find_if(std::begin(Kinds), std::end(Kinds), [&](const auto& one) { return word == one.first; });
    const auto robot = node["robot"].as<std::string>();
    if (kind == std::end(Kinds) || robot.size() > LongestName) return std::nullopt;
    return HeldGrant{{kind->second, robot}, node["term"].as<std::uint64_t>()};
}

/// Parses @p file; empty when it is invalid.
std::optional<StationIdentity> parse(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string text(LargestFile + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseStation(text);
}

}  // namespace

std::optional<StationIdentity> parseStation(const std::string& text) {
    if (text.size() > LargestFile) return std::nullopt;
    try {
        const YAML::Node root = YAML::Load(text);
        StationIdentity station;
        station.id = root["station"].as<std::string>();
        const bool plain = std::all_of(station.id.begin(), station.id.end(), [](unsigned char c) {
            return std::isalnum(c) != 0 || c == '-' || c == '_';
        });
        if (station.id.empty() || station.id.size() > LongestName || !plain) return std::nullopt;
        for (const YAML::Node& node : root["grants"]) {
            const auto grant = grantOf(node);
            if (!grant || station.held.size() >= MostGrants) return std::nullopt;
            station.held.push_back(*grant);
        }
        return station;
    } catch (const YAML::Exception&) {
        return std::nullopt;
    }
}

namespace {

Error failed(const std::filesystem::path& file, const char* what) {
    return Error{fmt::format("{}: {}: {}", file.string(), what, std::strerror(errno))};
}

/// Replaces the content of @p file by @p text. Even after a power failure, the file holds either all of it or
/// its old content.
Result<void> replace(const std::filesystem::path& file, const std::string& text) {
    const std::filesystem::path next = file.string() + ".new";
    const int out = ::open(next.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (out < 0) return failed(next, "cannot be written");
    const bool written =
        ::write(out, text.data(), text.size()) == static_cast<ssize_t>(text.size()) && ::fsync(out) == 0;
    const int why = errno;
    ::close(out);
    errno = why;
    if (!written) return failed(next, "cannot be written");
    if (::rename(next.c_str(), file.c_str()) != 0) return failed(file, "cannot be replaced");
    return {};
}

}  // namespace

/// The lock on an identity; released when the process ends in any way.
struct StationFile::Lock {
    explicit Lock(int held) : descriptor(held) {}
    ~Lock() { ::close(descriptor); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    int descriptor;
};

std::string newStationId() {
    std::random_device random;  // of the system
    std::string digits;
    while (digits.size() < 32) digits += fmt::format("{:08x}", random());
    digits[12] = '4';                                                     // version
    digits[16] = "89ab"[static_cast<std::size_t>(digits[16] - '0') % 4];  // variant
    return fmt::format("{}-{}-{}-{}-{}", digits.substr(0, 8), digits.substr(8, 4), digits.substr(12, 4),
                       digits.substr(16, 4), digits.substr(20, 12));
}

Result<StationFile> StationFile::open(const std::filesystem::path& file, const std::string& title) {
    std::error_code error;
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), error);
    // A lock file beside it, since the file itself is replaced by renaming.
    const std::filesystem::path beside = file.string() + ".lock";
    const int descriptor = ::open(beside.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (descriptor < 0) return failed(beside, "cannot be opened");
    StationFile station;
    station.m_lock = std::make_shared<const Lock>(descriptor);
    if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
        return Error{
            fmt::format("{}: the identity of this station is in use by another program", file.string())};
    }
    station.m_file = file;
    const bool there = std::filesystem::exists(file, error);
    if (const auto known = there ? parse(file) : std::nullopt) {
        station.m_identity = *known;
        station.m_identity.title = title;
        return station;
    }
    if (there) {
        const std::filesystem::path aside = file.string() + ".damaged";
        std::filesystem::rename(file, aside, error);
        station.m_warning = fmt::format(
            "{}: could not be understood; this station has a new identity and no grants, the old "
            "file is {}",
            file.string(), aside.string());
    }
    station.m_identity = {newStationId(), title, {}};
    if (auto written = replace(file, textOf(station.m_identity)); !written) return written.error();
    return station;
}

Result<void> StationFile::remember(const std::vector<HeldGrant>& held) const {
    return replace(m_file, textOf({m_identity.id, m_identity.title, held}));
}

}  // namespace leitstand
