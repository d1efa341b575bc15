#include "core/io/settings/comparison_file.h"

#include <array>
#include <fstream>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/words.h"
#include "core/io/detail/output_file.h"
#include "core/io/yaml/yaml_document.h"
#include "core/io/yaml/yaml_fields.h"

namespace leitstand {
namespace {

using detail::YamlErrors;
using detail::YamlFields;
using detail::YamlPlace;

constexpr std::string_view Keys[] = {"minimizer", "reference", "reduce", "max_distances", "rejected",
                                     "seconds",   "recorded",  "again",  "scans"};
constexpr std::string_view MapKeys[] = {"truth", "finds"};
constexpr std::string_view ScanKeys[] = {
    "id", "recorded", "again", "uncertain_recorded", "uncertain_again", "fit_recorded", "fit_again"};
constexpr double Far = 1e5, LongestJob = 1e6;  ///< [m], [s]
constexpr double NearOne = 1e-3;               ///< largest deviation of a quaternion's length
constexpr int Most = 1'000'000;

std::vector<std::pair<std::string, Minimizer>> minimizerKeys() {
    std::vector<std::pair<std::string, Minimizer>> keys;
    for (const MinimizerRow& row : minimizers()) keys.emplace_back(row.key, row.minimizer);
    return keys;
}

const std::vector<std::pair<std::string, Reference>> References = {{"previous", Reference::Previous},
                                                                   {"map", Reference::Map}};

template <class T>
std::string wordOf(const std::vector<std::pair<std::string, T>>& words, T value) {
    for (const auto& [word, meaning] : words) {
        if (meaning == value) return word;
    }
    return words.front().first;
}

std::string listOf(const std::vector<double>& values) {
    return fmt::format("[{:.9g}]", fmt::join(values, ", "));
}

/// Returns x y z and the quaternion x y z w, as in TUM lines.
std::string poseText(const Pose& pose) {
    const Eigen::Vector3d& at = pose.translation();
    const Eigen::Quaterniond turn(pose.linear());
    return listOf({at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()});
}

std::string fitText(const char* key, const std::optional<ScanFit>& fit) {
    return fit ? fmt::format(", {}: {}", key, listOf({fit->rms, fit->overlap})) : std::string();
}

std::string figuresText(const char* key, const MapFigures& figures) {
    std::string text;
    if (figures.truth) {
        const TrajectoryError& error = *figures.truth;
        text += fmt::format("  truth: {}\n",
                            listOf({static_cast<double>(error.poses), error.position, error.rotation}));
    }
    if (figures.finds) {
        const FindsError& error = *figures.finds;
        text += fmt::format("  finds: {}\n",
                            listOf({static_cast<double>(error.finds), error.mean, error.worst,
                                    static_cast<double>(error.missed), static_cast<double>(error.wrong)}));
    }
    return text.empty() ? text : fmt::format("{}:\n{}", key, text);
}

bool readPose(const YamlFields& fields, std::string_view key, Pose& pose) {
    std::vector<double> values;
    if (!fields.has(key)) return fields.fail(key, translate("leitstand::Error", "is missing"));
    if (!fields.numbers(key, values, 7, Far, " m")) return false;
    const Eigen::Quaterniond turn(values[6], values[3], values[4], values[5]);
    if (!(std::abs(turn.norm() - 1.0) < NearOne))
        return fields.fail(
            key, translate("leitstand::Error", "expected x y z [m] and a quaternion x y z w of length 1"));
    pose.linear() = turn.normalized().toRotationMatrix();
    pose.translation() = Eigen::Vector3d(values[0], values[1], values[2]);
    return true;
}

void readFit(const YamlFields& fields, std::string_view key, std::optional<ScanFit>& fit) {
    std::vector<double> values;
    if (!fields.has(key) || !fields.numbers(key, values, 2, Far, "")) return;
    if (values[0] < 0.0 || values[1] < 0.0 || values[1] > 1.0) {
        fields.fail(key, translate("leitstand::Error", "expected a distance [m] and a share from 0 to 1"));
        return;
    }
    fit = ScanFit{values[0], values[1]};
}

/// Reads a count and two amounts, none below 0.
bool readAmounts(const YamlFields& fields, std::string_view key, int& count, double& first, double& second) {
    std::vector<double> values;
    if (!fields.has(key) || !fields.numbers(key, values, 3, Far, "")) return false;
    if (values[0] < 0.0 || values[1] < 0.0 || values[2] < 0.0)
        return fields.fail(key,
                           translate("leitstand::Error", "expected a count and two amounts, none below 0"));
    count = static_cast<int>(values[0]);
    first = values[1];
    second = values[2];
    return true;
}

/// Reads the figures of the finds. Skips the three numbers of older files, which did not distinguish finds
/// and mean something else.
std::optional<FindsError> readFinds(const YamlFields& fields) {
    std::vector<double> values;
    if (!fields.has("finds") || fields.list("finds").size() == 3) return std::nullopt;
    if (!fields.numbers("finds", values, 5, Far, "")) return std::nullopt;
    FindsError finds{static_cast<int>(values[0]), values[1], values[2], static_cast<int>(values[3]),
                     static_cast<int>(values[4])};
    const bool none = std::any_of(values.begin(), values.end(), [](double one) { return one < 0.0; });
    if (!none && finds.wrong <= finds.finds) return finds;
    fields.fail("finds",
                translate("leitstand::Error",
                          "expected counts and amounts, none below 0, and no more wrong finds than finds"));
    return std::nullopt;
}

void readFigures(const YamlFields& fields, std::string_view key, MapFigures& figures, YamlErrors& errors) {
    if (!fields.has(key)) return;
    const YamlFields of(fields.at(key), MapKeys, errors);
    TrajectoryError truth;
    if (readAmounts(of, "truth", truth.poses, truth.position, truth.rotation)) figures.truth = truth;
    figures.finds = readFinds(of);
}

void readScan(const YamlPlace& place, MapComparison& whole, std::set<int>& seen, YamlErrors& errors) {
    const YamlFields fields(place, ScanKeys, errors);
    ComparedScan one;
    int id = 0;
    if (!fields.has("id")) fields.fail("id", translate("leitstand::Error", "is missing"));
    fields.count("id", id, 1, std::numeric_limits<int>::max());
    if (id > 0 && !seen.insert(id).second)
        fields.fail("id", translate("leitstand::Error", "stands in this file already"));
    one.id = static_cast<std::uint64_t>(id);
    readPose(fields, "recorded", one.recorded);
    readPose(fields, "again", one.again);
    fields.flag("uncertain_recorded", one.uncertainRecorded);
    fields.flag("uncertain_again", one.uncertainAgain);
    readFit(fields, "fit_recorded", one.fitRecorded);
    readFit(fields, "fit_again", one.fitAgain);
    whole.scans.push_back(std::move(one));
}

void readDistances(const YamlFields& fields, std::vector<double>& distances) {
    constexpr double Least = 1e-6, Largest = 1e3;  // [m]
    if (!fields.has("max_distances")) return;
    distances.clear();
    for (const YamlPlace& place : fields.list("max_distances")) {
        double value = 0.0;
        if (detail::isNumber(place.value, value) && value >= Least && value <= Largest) {
            distances.push_back(value);
        } else {
            fields.fail("max_distances",
                        translate("leitstand::Error", "expected distances above 0 and up to 1000 m"));
            return;
        }
    }
    if (distances.empty())
        fields.fail("max_distances", translate("leitstand::Error", "expected at least one distance"));
}

void readAll(const YamlFields& fields, MapComparison& whole, YamlErrors& errors) {
    fields.choice("minimizer", whole.settings.minimizer, minimizerKeys());
    fields.choice("reference", whole.settings.reference, References);
    fields.number("reduce", whole.settings.reduce, 0.0, Far, " m");
    readDistances(fields, whole.settings.maxDistances);
    fields.count("rejected", whole.rejected, 0, Most);
    double seconds = 0.0;
    if (fields.has("seconds") && fields.number("seconds", seconds, 0.0, LongestJob, " s"))
        whole.again.seconds = seconds;
    readFigures(fields, "recorded", whole.recorded, errors);
    readFigures(fields, "again", whole.again, errors);
    std::set<int> seen;
    const auto scans = fields.list("scans");
    if (scans.empty()) fields.fail("scans", translate("leitstand::Error", "expected a list of key scans"));
    for (const YamlPlace& place : scans) readScan(place, whole, seen, errors);
}

}  // namespace

std::string writeComparison(const MapComparison& whole) {
    const RegistrationSettings& settings = whole.settings;
    std::string text =
        "# What registering this mission's key scans again made of them; Leitstand's review shows it.\n";
    text += fmt::format("minimizer: {}\nreference: {}\nreduce: {:.9g}\nmax_distances: {}\nrejected: {}\n",
                        rowOf(settings.minimizer).key, wordOf(References, settings.reference),
                        settings.reduce, listOf(settings.maxDistances), whole.rejected);
    if (whole.again.seconds) text += fmt::format("seconds: {:.9g}\n", *whole.again.seconds);
    text += figuresText("recorded", whole.recorded) + figuresText("again", whole.again) + "scans:\n";
    for (const ComparedScan& one : whole.scans) {
        text += fmt::format("  - {{id: {}, recorded: {}, again: {}", one.id, poseText(one.recorded),
                            poseText(one.again));
        if (one.uncertainRecorded) text += ", uncertain_recorded: true";
        if (one.uncertainAgain) text += ", uncertain_again: true";
        text += fitText("fit_recorded", one.fitRecorded) + fitText("fit_again", one.fitAgain) + "}\n";
    }
    return text;
}

Result<MapComparison> parseComparison(std::string_view text, const std::string& name) {
    const auto root = detail::loadYaml(text, name);
    if (!root) return root.error();
    YamlErrors errors(name);
    MapComparison whole;
    readAll(YamlFields({*root, {}, 1}, Keys, errors), whole, errors);
    if (!errors.empty()) return errors.error();
    sumUp(whole);
    return whole;
}

Result<MapComparison> readComparison(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    std::string text(detail::LargestYaml + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
    return parseComparison(text, file.string());
}

Result<void> saveComparison(const MapComparison& comparison, const std::filesystem::path& file) {
    const std::string text = writeComparison(comparison);
    if (text.size() > detail::LargestYaml)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: {} scans are more than it takes"),
                                     file.string(), comparison.scans.size())};
    return detail::writeWhole(file, text);
}

}  // namespace leitstand
