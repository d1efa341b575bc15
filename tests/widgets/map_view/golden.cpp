#include "tests/widgets/map_view/golden.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "tests/support/places.h"

namespace leitstand::test {
namespace {

constexpr int ChannelTolerance = 32;
constexpr double DifferingShare = 0.01;

QString goldenFile(const std::string& name) {
    const auto folder = std::filesystem::path(sourceFolder()) / "tests/widgets/map_view/golden";
    return QString::fromStdString((folder / (name + ".png")).string());
}

bool differ(QRgb a, QRgb b) {
    return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                     std::abs(qBlue(a) - qBlue(b))}) > ChannelTolerance;
}

/// White where the pictures differ; @p count tells in how many pixels.
QImage differences(const QImage& a, const QImage& b, int& count) {
    QImage marked(a.size(), QImage::Format_RGB32);
    count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const bool different = differ(a.pixel(x, y), b.pixel(x, y));
            marked.setPixel(x, y, different ? 0xFFFFFFFF : 0xFF000000);
            count += different ? 1 : 0;
        }
    }
    return marked;
}

}  // namespace

testing::AssertionResult looksLikeGolden(const QImage& picture, const std::string& name) {
    const QString file = goldenFile(name);
    if (qEnvironmentVariableIntValue("LEITSTAND_UPDATE_GOLDEN") == 1) {
        if (picture.save(file)) return testing::AssertionSuccess();
        return testing::AssertionFailure() << file.toStdString() << " cannot be written";
    }
    const QString actual = QString::fromStdString(name + "-actual.png");
    const QImage golden(file);
    if (golden.size() != picture.size()) {
        picture.save(actual);
        return testing::AssertionFailure()
               << file.toStdString() << " is missing or of another size; saved " << actual.toStdString();
    }
    int count = 0;
    const QImage marked = differences(picture, golden, count);
    const double share = double(count) / (double(picture.width()) * picture.height());
    if (share <= DifferingShare) return testing::AssertionSuccess() << 100 * share << " % of pixels differ";
    picture.save(actual);
    marked.save(QString::fromStdString(name + "-diff.png"));
    return testing::AssertionFailure()
           << 100 * share << " % of the pixels differ from " << file.toStdString() << "; saved "
           << actual.toStdString() << " and " << name << "-diff.png";
}

}  // namespace leitstand::test
