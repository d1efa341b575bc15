#include "core/perception/pictures/sharpness.h"

#include "core/perception/pictures/coding/picture_mat.h"

namespace leitstand {

double sharpness(const Picture& picture) {
    constexpr int Widest = 320;
    cv::Mat grey = greyOf(picture);
    if (grey.empty()) return 0.0;
    if (grey.cols > Widest) {
        const double scale = static_cast<double>(Widest) / grey.cols;
        cv::Mat small;
        cv::resize(grey, small, {}, scale, scale, cv::INTER_AREA);
        grey = small;
    }
    cv::Mat edges;
    cv::Laplacian(grey, edges, CV_32F);
    cv::Scalar mean, deviation;
    cv::meanStdDev(edges, mean, deviation);
    return deviation[0] * deviation[0];
}

}  // namespace leitstand
