#include "core/perception/cues/motion.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/base/time.h"
#include "core/perception/pictures/coding/picture_mat.h"

namespace leitstand {
namespace {

constexpr double UsualMean = 1.0;  // a darker picture gives no brightness to compare by

/// Median of @p change (absolute values), over every third pixel.
double middleOf(const cv::Mat& change) {
    std::vector<float> values;
    for (int y = 0; y < change.rows; y += 3) {
        const auto* row = change.ptr<float>(y);
        for (int x = 0; x < change.cols; x += 3) values.push_back(row[x]);
    }
    if (values.empty()) return 0.0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return static_cast<double>(*middle);
}

double shareOf(double seconds, double constant) {
    return 1.0 - std::exp(-seconds / constant);
}

}  // namespace

struct MotionFinder::State {
    MotionSettings settings;
    cv::Mat last, background, activity;  ///< 8 bits; floats; floats, 0 to 1
    Time begun{}, newest{};

    void begin(const cv::Mat& grey, Time stamp);
    [[nodiscard]] std::vector<MotionBlob> blobs(const cv::Mat& change) const;
};

void MotionFinder::State::begin(const cv::Mat& grey, Time stamp) {
    last = grey.clone();
    cv::Mat soft;
    cv::GaussianBlur(grey, soft, {5, 5}, 0.0);
    soft.convertTo(background, CV_32F);
    activity = cv::Mat::zeros(grey.size(), CV_32F);
    begun = newest = stamp;
}

std::vector<MotionBlob> MotionFinder::State::blobs(const cv::Mat& change) const {
    cv::Mat busy = activity > settings.often;
    cv::morphologyEx(busy, busy, cv::MORPH_CLOSE, cv::Mat::ones(7, 7, CV_8U));
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(busy, labels, stats, centres, 8, CV_32S);
    const double least = settings.smallest * static_cast<double>(busy.total());
    std::vector<MotionBlob> found;
    for (int i = 1; i < count; ++i) {
        if (stats.at<int>(i, cv::CC_STAT_AREA) < least) continue;
        MotionBlob blob;
        blob.left = stats.at<int>(i, cv::CC_STAT_LEFT);
        blob.top = stats.at<int>(i, cv::CC_STAT_TOP);
        blob.right = blob.left + stats.at<int>(i, cv::CC_STAT_WIDTH) - 1;
        blob.bottom = blob.top + stats.at<int>(i, cv::CC_STAT_HEIGHT) - 1;
        double weights = 0.0, changes = 0.0;
        for (int y = blob.top; y <= blob.bottom; ++y) {
            for (int x = blob.left; x <= blob.right; ++x) {
                if (labels.at<int>(y, x) != i) continue;
                const auto weight = static_cast<double>(activity.at<float>(y, x));
                blob.centre += weight * Eigen::Vector2d(x + 0.5, y + 0.5);
                weights += weight;
                changes += weight * static_cast<double>(change.at<float>(y, x));
            }
        }
        if (!(weights > 0.0)) continue;
        blob.centre /= weights;
        const double often = weights / stats.at<int>(i, cv::CC_STAT_AREA);
        const double much = std::min(1.0, changes / weights / (2.0 * settings.contrast));
        blob.strength = std::clamp(often * (0.5 + 0.5 * much), 0.0, 1.0);
        found.push_back(blob);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const MotionBlob& a, const MotionBlob& b) { return a.strength > b.strength; });
    return found;
}

MotionFinder::MotionFinder(const MotionSettings& settings) : m_state(std::make_unique<State>()) {
    m_state->settings = settings;
}
MotionFinder::~MotionFinder() = default;
MotionFinder::MotionFinder(MotionFinder&&) noexcept = default;
MotionFinder& MotionFinder::operator=(MotionFinder&&) noexcept = default;

void MotionFinder::moved() {
    m_state->background.release();
}

std::vector<MotionBlob> MotionFinder::look(const Picture& picture, Time stamp) {
    State& state = *m_state;
    const MotionSettings& settings = state.settings;
    const cv::Mat grey = greyOf(picture);
    if (grey.empty()) {
        moved();
        return {};
    }
    const double since = toSeconds(stamp - state.newest);
    const bool again =
        state.background.empty() || state.background.size() != grey.size() || since > settings.longestGap;
    if (again || since < 0.0) {
        state.begin(grey, stamp);
        return {};
    }
    if (since == 0.0 || cv::norm(grey, state.last, cv::NORM_INF) == 0.0) return {};  // repeats
    state.last = grey.clone();
    state.newest = stamp;
    cv::Mat soft, now;
    cv::GaussianBlur(grey, soft, {5, 5}, 0.0);
    // Gain control makes the whole picture brighter or darker: this is no motion.
    const double mean = cv::mean(soft)[0], usual = cv::mean(state.background)[0];
    soft.convertTo(now, CV_32F, mean > UsualMean ? usual / mean : 1.0);
    cv::Mat change;
    cv::absdiff(now, state.background, change);
    const double least = std::max(settings.contrast, settings.noise * 1.48 * middleOf(change));
    cv::Mat moving;
    cv::threshold(change, moving, least, 1.0, cv::THRESH_BINARY);
    const double share = cv::mean(moving)[0];
    if (share > settings.largest) {
        state.begin(grey, stamp);
        return {};
    }
    const double seen = shareOf(since, settings.activity);
    cv::addWeighted(state.activity, 1.0 - seen, moving, seen, 0.0, state.activity);
    cv::accumulateWeighted(now, state.background, shareOf(since, settings.background));
    if (toSeconds(stamp - state.begun) < settings.warmUp) return {};
    return state.blobs(change);
}

}  // namespace leitstand
